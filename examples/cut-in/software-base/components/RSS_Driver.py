"""The driver of Responsibility-Sensitive Safety, arXiv 1708.06374 (an existing component)."""

from drivers import HARDER, HARDEST, Reaction

REACTION = 0.75
"""s."""
ACCELERATION = 3.0
"""m/s2, of the own vehicle in the reaction at worst."""
BRAKING = 6.0
"""m/s2, of both vehicles."""
LATERAL = 1.0
"""m/s2, of both vehicles across the road."""
LATERAL_DISTANCE = 0.3
"""m, that always stays."""


def safe_along(speed, other_speed):
    """Take m/s; return the safe distance along the road in m."""
    fastest = speed + REACTION * ACCELERATION
    reacting = speed * REACTION + ACCELERATION * REACTION**2 / 2
    return reacting + fastest**2 / (2 * BRAKING) - other_speed**2 / (2 * BRAKING)


def safe_across(lateral_speed):
    """Take m/s; return the safe distance across the road in m."""
    fastest = lateral_speed + REACTION * LATERAL
    return LATERAL_DISTANCE + (lateral_speed + fastest) * REACTION / 2 + fastest**2 / (2 * LATERAL)


class RSS_Driver:
    """Reacts while neither distance is safe."""

    def __init__(self):
        self._reaction = Reaction(REACTION)
        self._deceleration = 0.0

    def execute(self, ahead, distance_along, distance_across, other_speed, lateral_speed, speed):
        """Take m and m/s; return the deceleration in m/s2."""
        unsafe = (
            ahead and distance_along < safe_along(speed, other_speed) and distance_across < safe_across(lateral_speed)
        )
        if not unsafe or self._reaction.lasts():
            return {"deceleration": 0.0}
        self._deceleration = min(self._deceleration + HARDER, HARDEST)
        return {"deceleration": self._deceleration}
