"""The competent and careful human driver of UN Regulation No. 157, Annex 4, Appendix 3 (an existing component)."""

from drivers import HARDER, HARDEST, Reaction, time_to_collision

LONGEST = 2.0
"""s, the time to collision to which the driver reacts."""
LIFTED = 0.4
"""m/s2, while the driver changes to the brake."""


class CC_Driver:
    """Sees a cut-in when the bodies overlap across the road."""

    def __init__(self):
        self._reaction = Reaction(0.75)
        self._deceleration = LIFTED

    def execute(self, ahead, distance_along, distance_across, other_speed, speed):
        """Take m and m/s; return the deceleration in m/s2."""
        seconds = time_to_collision(distance_along, speed - other_speed)
        if not ahead or distance_across > 0.0 or seconds > LONGEST:
            return {"deceleration": 0.0}
        if not self._reaction.lasts():
            self._deceleration = min(self._deceleration + HARDER, HARDEST)
        return {"deceleration": self._deceleration}
