import sys
print("ESCAPED", open(sys.argv[1] + "/canary.txt").read())
