import os, sys
os.truncate(sys.argv[1] + "/canary.txt", 0)
