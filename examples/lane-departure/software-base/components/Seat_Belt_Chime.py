"""Reminds the driver of the seat belt (an existing component, not part of lane departure warning)."""

SLOWEST = 5.0
"""m/s"""


class Seat_Belt_Chime:
    """Sounds while the vehicle drives with an open belt."""

    def execute(self, speed, closed):
        """Take the speed in m/s and whether the belt is closed; return whether the chime sounds."""
        return {"sounds": speed > SLOWEST and not closed}
