import math


class Time_Left:
    """Time until the shortest distance is used up."""

    def execute(self, distances, speed):
        valid = [d for d in distances if math.isfinite(d)]
        if not valid or not speed > 0.0:
            return {"time_left": 1000.0}
        return {"time_left": max(0.0, min(min(valid) / speed, 1000.0))}
