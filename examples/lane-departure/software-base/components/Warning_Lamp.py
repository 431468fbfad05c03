"""Lights the lamps of the lane departure warning (an existing component)."""

SHORTEST = 50
"""Calls at 50 Hz for which a lamp is lit at least: 1 s."""


class Warning_Lamp:
    """Keeps a lamp lit for a while, so that the driver sees it."""

    def __init__(self):
        """Start with dark lamps."""
        self._left = 0
        self._right = 0

    def execute(self, left, right):
        """Take what is requested; return what is lit."""
        self._left = self._remaining(self._left, left, right)
        self._right = self._remaining(self._right, right, left)
        return {"left_lamp": self._left > 0, "right_lamp": self._right > 0}

    @staticmethod
    def _remaining(calls, requested, other):
        """Return for how many calls a lamp stays lit, this one included."""
        if requested:
            return max(calls - 1, 1) if calls > 0 else SHORTEST
        return 0 if other else max(calls - 1, 0)
