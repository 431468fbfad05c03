import io, sys
class Lie:
    __class__ = property(lambda self: int)
    def __fspath__(self):
        return sys.argv[1] + "/written"
io.FileIO(Lie(), "w").write(b"x")
