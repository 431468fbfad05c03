"""Turns a wanted acceleration into throttle and brake (an existing component)."""

import math

COASTING = 0.5
"""m/s2; the vehicle slows down so without throttle and brake."""
FULL_THROTTLE = 3.0
"""m/s2 at a throttle of 1."""
FULL_BRAKE = 9.0
"""m/s2 at a brake of 1."""
PERIOD = 0.02
"""s from call to call, at 50 Hz."""
DELAY = 12
"""Calls until a request shows in the measured acceleration."""
LEARNING = 0.6
"""1/s; how fast the correction follows what is missing."""
LARGEST_CORRECTION = 1.5
"""m/s2; more is no resistance of the air."""
STEADY = 0.2
"""m/s2; while the request changes by more within the delay, nothing is learnt."""
STANDSTILL = 0.3
"""m/s; more slowly than that nothing is learnt."""


class Longitudinal_Actuation:
    """Feeds the wanted acceleration forward, and learns what the resistance of the air takes."""

    def __init__(self):
        """Start without a request."""
        self._requests = []
        self._correction = 0.0

    def execute(self, active, wanted_acceleration, speed, acceleration):
        """Take m/s2, m/s and m/s2; return throttle and brake, 0 to 1 each and never both."""
        if not active or math.isnan(wanted_acceleration):
            self._requests.clear()
            self._correction = 0.0
            return {"throttle": 0.0, "brake": 0.0}
        wanted = max(-FULL_BRAKE, min(FULL_THROTTLE, wanted_acceleration))
        self._learn(wanted, speed, acceleration)
        driven = wanted + self._correction
        if wanted > -COASTING or driven > -COASTING:
            throttle = (driven + COASTING) / (FULL_THROTTLE + COASTING)
            return {"throttle": max(0.0, min(1.0, throttle)), "brake": 0.0}
        return {"throttle": 0.0, "brake": max(0.0, min(1.0, -driven / FULL_BRAKE))}

    def _learn(self, wanted, speed, acceleration):
        """Compare the measured acceleration with the request that it is due to."""
        self._requests.append(wanted)
        if len(self._requests) <= DELAY:
            return
        request = self._requests.pop(0)
        missing = request - acceleration
        steady = abs(wanted - request) < STEADY
        if steady and math.isfinite(missing) and speed > STANDSTILL:
            correction = self._correction + LEARNING * PERIOD * missing
            self._correction = max(-LARGEST_CORRECTION, min(LARGEST_CORRECTION, correction))
