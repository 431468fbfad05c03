import os, signal
os.kill(-1, 0)
print("ESCAPED")
