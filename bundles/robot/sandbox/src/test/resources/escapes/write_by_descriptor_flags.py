import os, sys
os.close(os.open(sys.argv[1] + "/written", os.O_RDONLY | os.O_CREAT))
