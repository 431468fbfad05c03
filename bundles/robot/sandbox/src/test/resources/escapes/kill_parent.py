import os, signal
os.kill(os.getppid(), 0)
print("ESCAPED")
