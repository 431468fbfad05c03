import sys
del sys.modules["posix"]
import posix
posix.mkfifo(sys.argv[1] + "/pipe")
