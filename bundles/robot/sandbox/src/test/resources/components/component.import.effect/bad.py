import math

LIMITS = [math.radians(30), 2.0]
print("loaded")
TABLE = TTC_table(5)
for i in range(3):
    LIMITS.append(i)


class TTC:
    for number in range(3):
        pass

    def execute(self, distance, speed):
        return {"ttc": 1.0}


TTC().execute(1.0, 2.0)
