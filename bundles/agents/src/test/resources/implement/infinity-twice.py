import math


class Time_Left:
    def __init__(self):
        self._speed = 0.0

    def execute(self, distances, speed):
        speed = 0.0 if math.isnan(speed) else speed
        change = speed - self._speed
        self._speed = speed
        return {"time_left": min(max(change, 0.0), 1000.0)}
