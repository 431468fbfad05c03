import os
if os.system("true") == 0:
    print("ESCAPED")
