"""What the drivers have in common (imported by the components)."""

STEP = 0.1
"""s, from one sample to the next."""
HARDEST = 0.774 * 9.81
"""m/s2, the full deceleration of a human driver."""
HARDER = 12.65 * STEP
"""m/s2, by which the deceleration grows in a step."""


class Reaction:
    """The time that a driver needs before the brake: it passes in unsafe samples only, and never begins anew."""

    def __init__(self, seconds):
        self._left = seconds

    def lasts(self):
        """Return whether the driver does not brake in this unsafe sample yet."""
        lasts = self._left > 0.0
        self._left -= STEP
        return lasts


def time_to_collision(distance, closing_speed):
    """Return the time in s by the size of the closing speed; infinite without one."""
    return abs(distance / closing_speed) if closing_speed != 0.0 else float("inf")
