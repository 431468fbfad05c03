import math


class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": math.inf if not speed > 0.0 else 1000.0}
