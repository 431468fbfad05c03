import os
os.setpriority(os.PRIO_PROCESS, os.getppid(), 1)
print("ESCAPED")
