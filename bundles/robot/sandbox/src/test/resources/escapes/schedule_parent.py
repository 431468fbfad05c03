import ctypes, os
library = ctypes.CDLL(None)
mask = ctypes.create_string_buffer(b"\x01" + bytes(127))
if library.sched_setaffinity(os.getppid(), 128, mask) == 0 or library.sched_setaffinity(0, 128, mask) == 0:
    print("ESCAPED affinity")
batch = (ctypes.c_int * 1)(0)
if library.sched_setscheduler(os.getppid(), 3, batch) == 0 or library.sched_setscheduler(0, 3, batch) == 0:
    print("ESCAPED scheduler")
