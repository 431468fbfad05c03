import os
print("ESCAPED", open(f"/proc/{os.getppid()}/environ", "rb").read(1))
