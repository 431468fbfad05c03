import apsw, sys
apsw.Connection(sys.argv[1] + "/written").execute("create table t (x)")
