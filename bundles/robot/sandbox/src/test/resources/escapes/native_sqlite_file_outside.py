import _sqlite3, sys
database = _sqlite3.connect(sys.argv[1] + "/written")
database.execute("create table t (x)")
database.commit()
