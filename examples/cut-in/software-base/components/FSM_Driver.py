"""The driver of the Fuzzy Safety Model, Mattas et al. 2020 (an existing component)."""

from drivers import HARDER, HARDEST, STEP, Reaction

REACTION = 0.75
"""s."""
COMFORTABLE = 4.0
"""m/s2, of the own vehicle."""
STRONGEST = 6.0
"""m/s2, of the own vehicle."""
OTHER = 7.0
"""m/s2, of the other vehicle."""
MARGIN = 2.0
"""m, that stays at standstill."""
BODIES = 8.6
"""m, the length of both vehicles."""
LATERAL_MARGIN = 0.1
"""s."""


def between(distance, unsafe, safe):
    """Return how unsafe a distance is: 0 from `safe` on, 1 up to `unsafe`."""
    if distance >= safe:
        return 0.0
    return 1.0 if distance < unsafe else (distance - safe) / (unsafe - safe)


def proactive(distance, speed, other_speed):
    """Take m and m/s; return how little would be left if the other vehicle braked to a standstill, 0 to 1."""
    reacting = REACTION * speed - other_speed**2 / (2 * OTHER)
    safe = reacting + speed**2 / (2 * COMFORTABLE) + MARGIN
    return between(distance - MARGIN, reacting + speed**2 / (2 * STRONGEST), safe)


def critical(distance, speed, other_speed, acceleration):
    """Take m, m/s and m/s2; return how little is left if the other vehicle keeps its speed, 0 to 1."""
    closing = speed - other_speed
    if closing <= 0.0:
        return 0.0
    expected = max(acceleration, -COMFORTABLE)
    later = closing + REACTION * expected
    if later < 0.0:
        return 1.0 if distance < closing**2 / abs(2 * acceleration) else 0.0
    reacting = REACTION * (closing + REACTION * expected / 2)
    safe = reacting + later**2 / (2 * COMFORTABLE)
    return between(distance, reacting + later**2 / (2 * STRONGEST), safe)


class FSM_Driver:
    """Brakes as much as it is unsafe, also before the bodies overlap across the road."""

    def __init__(self):
        self._reaction = Reaction(REACTION)
        self._deceleration = 0.0
        self._speed = None

    def execute(self, ahead, distance_along, distance_across, other_speed, lateral_speed, speed):
        """Take m and m/s; return the deceleration in m/s2."""
        acceleration = 0.0 if self._speed is None else (speed - self._speed) / STEP
        self._speed = speed
        if not ahead or self._passes(distance_along, distance_across, speed - other_speed, lateral_speed):
            return {"deceleration": 0.0}
        cfs = critical(distance_along, speed, other_speed, acceleration)
        pfs = proactive(distance_along, speed, other_speed)
        if cfs + pfs == 0.0 or self._reaction.lasts():
            return {"deceleration": 0.0}
        wanted = COMFORTABLE + (STRONGEST - COMFORTABLE) * cfs if cfs > 0.0 else COMFORTABLE * pfs
        self._deceleration = min(self._deceleration + HARDER, HARDEST, wanted)
        return {"deceleration": self._deceleration}

    @staticmethod
    def _passes(distance_along, distance_across, closing, lateral_speed):
        """Return whether the vehicle has passed before the other one is in its way."""
        if distance_across <= 0.0:
            return False
        if lateral_speed <= 0.0:
            return True
        passing = (distance_along + BODIES) / closing if closing != 0.0 else float("inf")
        return distance_across / lateral_speed > passing + LATERAL_MARGIN
