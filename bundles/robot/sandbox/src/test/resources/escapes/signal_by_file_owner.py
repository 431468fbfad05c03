import fcntl, os
read, write = os.pipe()
fcntl.fcntl(read, 8, os.getpid())
fcntl.fcntl(read, 10, 23)
print("ESCAPED")
