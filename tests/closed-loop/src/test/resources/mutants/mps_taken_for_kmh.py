"""Wrong on purpose: its speed is in km/h."""

import math

LONGEST = 100.0
"""s; stands for every longer time, and for nothing ahead."""


class TTC_Calculation:
    """Divides the distance of the nearest obstacle by the speed at which it comes closer."""

    def __init__(self):
        """Start without a distance."""
        self._stamp = None
        self._distance = math.inf
        self._closing_speed = None

    def execute(self, scan_stamp_sec, scan_stamp_nanosec, ranges, velocity):
        """Take a scan in m and the ego speed in m/s; return the time to collision in s."""
        stamp = scan_stamp_sec + scan_stamp_nanosec * 1e-9
        distance = min((value for value in ranges if value >= 0.0), default=math.inf)
        if stamp != self._stamp:
            self._closing_speed = self._speed(stamp, distance, velocity)
            self._stamp, self._distance = stamp, distance
        closing_speed = (self._closing_speed or 0.0) * 3.6
        if not math.isfinite(distance) or closing_speed <= 0.0:
            return {"time_to_collision": LONGEST}
        return {"time_to_collision": min(LONGEST, distance / closing_speed)}

    def _speed(self, stamp, distance, velocity):
        if self._stamp is None or not math.isfinite(self._distance) or not math.isfinite(distance):
            return velocity
        return (self._distance - distance) / (stamp - self._stamp)
