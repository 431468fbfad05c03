import os, sys
print("ESCAPED", os.listdir(sys.argv[1]))
