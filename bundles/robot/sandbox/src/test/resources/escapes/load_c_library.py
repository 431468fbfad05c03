import ctypes, os, sys
library = ctypes.CDLL(None)
library.open((sys.argv[1] + "/written").encode(), os.O_CREAT | os.O_WRONLY, 0o644)
if library.socket(2, 1, 0) >= 0 or library.system(b"true") == 0:
    print("ESCAPED")
