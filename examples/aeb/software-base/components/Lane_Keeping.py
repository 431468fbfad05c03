"""Keeps the vehicle in its lane (an existing component, not part of emergency braking)."""

import math

OFFSET_GAIN = 0.3
"""rad of wanted heading per metre of offset."""
HEADING_GAIN = 1.2
"""Steering per rad of heading error."""
MINIMUM_SPEED = 0.5
"""m/s; below it the heading hardly changes, so the wheels stay straight."""


class Lane_Keeping:
    """Steers against lateral offset and heading error on a straight lane."""

    def execute(self, lateral_offset, orientation_z, orientation_w, forward_speed):
        """Take metres, a quaternion's z and w, and m/s; return steering in [-1, 1], right positive."""
        if forward_speed < MINIMUM_SPEED:
            return {"steering": 0.0}
        heading = 2.0 * math.atan2(orientation_z, orientation_w)
        heading = math.atan2(math.sin(heading), math.cos(heading))
        wanted = -math.atan(OFFSET_GAIN * lateral_offset)
        steering = HEADING_GAIN * (heading - wanted)
        return {"steering": max(-1.0, min(1.0, steering))}
