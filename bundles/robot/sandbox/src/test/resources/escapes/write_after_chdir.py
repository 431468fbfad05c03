import os, sys
os.chdir(sys.argv[1])
open("written", "w").write("x")
