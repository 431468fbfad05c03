import io, sys
class Lie(bytes):
    def decode(self, *arguments):
        return "/dev/null"
    def __buffer__(self, flags):
        return memoryview(b"/dev/null")
io.FileIO(Lie(sys.argv[1].encode() + b"/written"), "w").write(b"x")
