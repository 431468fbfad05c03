import os, sys
os.symlink(sys.argv[1], "link")
open("link/written", "w").write("x")
