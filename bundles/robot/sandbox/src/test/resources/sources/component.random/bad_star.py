from random import *


class TTC:
    def execute(self, distance, speed):
        return {"ttc": gauss(0.0, 1.0)}
