"""Constants."""

import math
from enum import Enum

GRAVITY: float = 9.81
"""m/s^2"""
LIMIT = math.radians(30.0) / GRAVITY
NAMES = tuple(sorted({"a", "b"}))


class Mode(Enum):
    OFF = 0
    ON = 1


class TTC:
    mode = Mode.ON

    def execute(self, distance, speed):
        return {"ttc": LIMIT}


if __name__ == "__main__":
    print(TTC().execute(1.0, 1.0))
