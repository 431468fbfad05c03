"""Another message."""


class Braking_Decision:
    """Brakes and warns."""

    def __init__(self):
        """Start without a warning."""
        self._before = False

    def execute(self, ttc, ranges):
        """Take ms and m."""
        if ttc != ttc:
            raise ValueError("wrong")
        warn = ttc < 2600.0
        shown = warn or self._before
        self._before = warn
        force = 1.0 if ttc < 1000.0 else 0.5 if ttc < 2000.0 else 0.0
        return {"braking_force": force, "warning": shown}
