import os, sys
os.chmod(sys.argv[1] + "/canary.txt", 0o777)
print("ESCAPED")
