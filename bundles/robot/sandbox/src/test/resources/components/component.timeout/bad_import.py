import math


class TTC:
    LIMIT = sum(math.sin(i) for i in range(10**12))

    def execute(self, distance, speed):
        return {"ttc": 1.0}
