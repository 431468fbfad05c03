"""Beeps in front of obstacles (an existing component, not part of cruise control)."""

FARTHEST = 1.5
"""m; no tone beyond it."""
NEAREST = 0.3
"""m; the tone is continuous there."""


class Parking_Aid:
    """Makes the tone more urgent the nearer an obstacle is."""

    def execute(self, front_distance):
        """Take m; return how urgent the tone is, 0 to 1."""
        if not front_distance < FARTHEST:
            return {"urgency": 0.0}
        return {"urgency": min(1.0, (FARTHEST - front_distance) / (FARTHEST - NEAREST))}
