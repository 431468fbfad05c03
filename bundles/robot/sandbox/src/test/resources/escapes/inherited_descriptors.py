# control: none
import os
for number in range(3, 64):
    try:
        os.fstat(number)
        print("ESCAPED", number)
    except OSError:
        pass
