import os
if os.environ.get("EVENTCHAIN_SECRET") or "root" in os.environ.get("PATH", "") or "USER" in os.environ:
    print("ESCAPED", os.environ)
