import math


class Time_Left:
    def execute(self, distances, speed):
        near = min((d for d in distances if math.isfinite(d)), default=1.0)
        return {"time_left": math.sqrt(near)}
