import sys
open(sys.argv[0], "a").write("#")
print("ESCAPED")
