import math


class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": math.clamp(speed, 0.0, 1000.0)}
