import os, sys
os.remove(sys.argv[1] + "/canary.txt")
