"""Brakes for what is near: the table is gone, and what has just been seen is not believed."""

FULL_BRAKE_TTC = 1.6
"""s"""
FULL_BRAKE = -9.0
"""m/s2"""
FAR = 100.0
"""s; larger times are those of nothing."""
CONFIRMED = 105
"""Activations with a target, 50 in a second."""


class Brake_Request:
    """Brakes fully below a time to collision with a target that has been there for a while."""

    def __init__(self):
        self._brakes = False
        self._seen = 0

    def execute(self, ttc, closing_speed):
        """Take s and m/s; return whether to brake, and with which acceleration in m/s2."""
        self._seen = self._seen + 1 if ttc < FAR else 0
        near = ttc < FULL_BRAKE_TTC and self._seen >= CONFIRMED
        self._brakes = near or (self._brakes and closing_speed > 0.0)
        return {"active": self._brakes, "acceleration": FULL_BRAKE if self._brakes else 0.0}
