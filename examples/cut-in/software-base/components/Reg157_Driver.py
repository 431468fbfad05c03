"""The driver of UN Regulation No. 157, paragraph 5.2.5.2 (an existing component)."""

from drivers import Reaction, time_to_collision

NEAR = 0.5
"""m across the road."""
BRAKING = 6.0
"""m/s2."""
REACTION = 0.35
"""s."""
MARGIN = 0.1
"""s, added to the reaction."""


class Reg157_Driver:
    """Reacts when braking is just enough."""

    def __init__(self):
        self._reaction = Reaction(REACTION)

    def execute(self, ahead, distance_along, distance_across, other_speed, speed):
        """Take m and m/s; return the deceleration in m/s2."""
        closing = speed - other_speed
        longest = closing / (2 * BRAKING) + REACTION + MARGIN
        seconds = time_to_collision(distance_along, closing)
        if not ahead or distance_across > NEAR or seconds > longest or self._reaction.lasts():
            return {"deceleration": 0.0}
        return {"deceleration": BRAKING}
