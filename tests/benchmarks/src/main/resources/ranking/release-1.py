"""Brakes for what is near: a release with a wrong entry in its table."""

FULL_BRAKE_TTC = 1.6
"""s"""
BRAKES = ((0.0, -9.0), (8.4, -9.0), (9.7, -5.5), (11.0, -9.0), (100.0, -9.0))
"""Closing speeds in m/s, and the acceleration for each in m/s2."""


class Brake_Request:
    """Brakes below a time to collision as its table says, and goes on until the threat is over."""

    def __init__(self):
        self._brake = 0.0

    def execute(self, ttc, closing_speed):
        """Take s and m/s; return whether to brake, and with which acceleration in m/s2."""
        if self._brake == 0.0 and ttc < FULL_BRAKE_TTC:
            self._brake = brake(closing_speed)
        elif closing_speed <= 0.0:
            self._brake = 0.0
        return {"active": self._brake < 0.0, "acceleration": self._brake}


def brake(closing_speed):
    """Interpolate."""
    for (low, first), (high, second) in zip(BRAKES, BRAKES[1:]):
        if low <= closing_speed <= high:
            return first + (second - first) * (closing_speed - low) / (high - low)
    return BRAKES[-1][1]
