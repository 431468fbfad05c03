"""Steers the vehicle to the middle of its lane (an existing component, not part of lane departure warning)."""

GAIN = 0.02
"""rad of the front wheels per metre off the middle."""
LARGEST = 0.05
"""rad"""


class Lane_Centering:
    """Steers in proportion to the offset from the middle of the lane."""

    def execute(self, left_distance, right_distance):
        """Take the distances to the lines in m; return the angle of the front wheels in rad."""
        offset = (right_distance - left_distance) / 2.0
        return {"angle": max(-LARGEST, min(LARGEST, -GAIN * offset))}
