import os, sys
open("mine", "w").write("x")
os.rename("mine", sys.argv[1] + "/written")
