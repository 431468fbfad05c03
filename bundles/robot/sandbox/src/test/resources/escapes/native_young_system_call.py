# control: none
import ctypes, os
library = ctypes.CDLL(None, use_errno=True)
for number in range(463, 520):
    if library.syscall(number, -1, -1, -1, -1, -1, -1) >= 0 or ctypes.get_errno() != 38:
        print("ESCAPED", number, ctypes.get_errno())
