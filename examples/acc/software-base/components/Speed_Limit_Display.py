"""Shows a speed warning (an existing component, not part of cruise control)."""

SPEED_LIMIT = 130.0 / 3.6
"""m/s"""
SAMPLES_BEFORE_WARNING = 5
"""Half a second at 10 Hz."""


class Speed_Limit_Display:
    """Warns after the vehicle has been too fast for a while."""

    def __init__(self):
        """Start without a warning."""
        self._samples_above = 0

    def execute(self, speed):
        """Take the speed in m/s; return whether the warning is shown."""
        self._samples_above = self._samples_above + 1 if speed > SPEED_LIMIT else 0
        return {"too_fast": self._samples_above >= SAMPLES_BEFORE_WARNING}
