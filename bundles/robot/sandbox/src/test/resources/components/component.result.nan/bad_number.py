import math


class TTC:
    def execute(self, distance, speed):
        if speed == 0.0:
            return {"ttc": math.inf - math.inf}
        return {"ttc": math.inf}
