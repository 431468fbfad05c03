"""Wrong on purpose: it never brakes."""

FULL_BRAKE_BELOW = -1.0
PARTIAL_BRAKE_BELOW = -1.0
PARTIAL_BRAKE = 0.5


class Braking_Decision:
    """Maps the time to collision to a normalized braking force."""

    def execute(self, time_to_collision):
        """Take seconds; return 1.0 below 1 s, 0.5 below 2 s, else 0.0."""
        if time_to_collision < FULL_BRAKE_BELOW:
            return {"braking_force": 1.0}
        if time_to_collision < PARTIAL_BRAKE_BELOW:
            return {"braking_force": PARTIAL_BRAKE}
        return {"braking_force": 0.0}
