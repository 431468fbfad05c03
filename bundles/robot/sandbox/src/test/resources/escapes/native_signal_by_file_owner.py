import ctypes, os
library = ctypes.CDLL(None)
read, write = os.pipe()
if library.fcntl(read, 8, os.getpid()) == 0 or library.fcntl(read, 10, 23) == 0:
    print("ESCAPED")
