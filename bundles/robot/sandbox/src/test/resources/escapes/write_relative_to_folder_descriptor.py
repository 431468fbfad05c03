import os, sys
folder = os.open(sys.argv[1], os.O_RDONLY)
os.close(os.open("written", os.O_WRONLY | os.O_CREAT, dir_fd=folder))
