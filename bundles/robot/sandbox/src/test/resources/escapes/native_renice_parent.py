import ctypes, os
library = ctypes.CDLL(None)
if library.setpriority(0, os.getppid(), 1) == 0 or library.setpriority(0, 0, 1) == 0:
    print("ESCAPED")
