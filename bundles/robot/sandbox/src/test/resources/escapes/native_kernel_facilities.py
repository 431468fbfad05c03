import ctypes, platform
library = ctypes.CDLL(None)
numbers = {"x86_64": (250, 323, 294), "aarch64": (219, 282, 26)}[platform.machine()]  # keyctl userfaultfd inotify_init1
for number, arguments in zip(numbers, ((0, 0xFFFFFFFD, 0), (1,), (0,))):
    if library.syscall(number, *arguments) >= 0:
        print("ESCAPED", number)
if library.syscall(434, 1, 0) >= 0:
    print("ESCAPED pidfd_open")
if library.syscall(425, 1, ctypes.create_string_buffer(120)) >= 0:
    print("ESCAPED io_uring_setup")
