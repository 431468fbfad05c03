import ctypes
library = ctypes.CDLL(None)
queue, semaphore, memory = library.msgget(0, 0o1600), library.semget(0, 1, 0o1600), library.shmget(0, 4096, 0o1600)
if queue >= 0 or semaphore >= 0 or memory >= 0:
    print("ESCAPED")
library.msgctl(queue, 0, None)
library.semctl(semaphore, 0, 0)
library.shmctl(memory, 0, None)
