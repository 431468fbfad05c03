# control: none
import numpy
open(numpy.__file__.replace("__init__.py", "written_by_escape"), "w").write("x")
print("ESCAPED")
