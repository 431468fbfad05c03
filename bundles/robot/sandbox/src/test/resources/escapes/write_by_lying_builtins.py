import builtins, sys
real_open = open
builtins.bool = lambda value: False
builtins.isinstance = lambda value, kind: False
builtins.str = bytes
real_open(sys.argv[1] + "/written", "w").write("x")
