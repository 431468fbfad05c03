"""The lamp in the left mirror."""

LANE = (-5.6, -1.9)
"""m, the left lane as the rear radar sees it: to the right of its direction."""
NEAR = 15.0
"""m behind the rear bumper."""
TIME = 3.0
"""s until what comes nearer is beside."""
BESIDE = 4.5
"""m; what is nearer on the left side is a vehicle in the next lane."""


class Blind_Spot_Monitor:
    """Lights the lamp while a vehicle is beside or comes near from behind in the left lane."""

    def execute(self, objects, ranges):
        """Take the objects behind and the distances to the left (m)."""
        behind = any(self._warns(each) for each in objects)
        beside = any(distance < BESIDE for distance in ranges)
        return {"lamp": behind or beside}

    @staticmethod
    def _warns(each):
        """Return whether an object behind is a reason to warn."""
        if each.classification != 1 or not LANE[0] <= each.position.y <= LANE[1]:
            return False
        nears = each.range_rate < -0.5 and each.position.x < -each.range_rate * TIME
        return each.position.x < NEAR or nears
