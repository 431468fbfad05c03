import math


class Example:
    def execute(self, speed, angle, stamp):
        heading = math.radians(angle) + angle * math.pi / 180
        return {"kmh": (speed + 0.5) * 3.6, "heading": heading, "seconds": stamp / 1e9, "half": speed / 2.0}
