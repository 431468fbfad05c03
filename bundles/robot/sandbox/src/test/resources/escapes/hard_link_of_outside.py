import os, sys
os.link(sys.argv[1] + "/canary.txt", "linked")
open("linked", "w").write("x")
