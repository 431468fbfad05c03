import os, sys
os.rename(sys.argv[1] + "/canary.txt", sys.argv[1] + "/renamed")
