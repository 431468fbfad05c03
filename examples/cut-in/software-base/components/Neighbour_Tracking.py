"""Where the neighbour is (an existing component)."""

LENGTH = 4.3
"""m, of the own vehicle."""
WIDTH = 1.9
"""m, of the own vehicle."""
NOBODY = {"ahead": False, "distance_along": 1000.0, "distance_across": 1000.0, "speed": 0.0, "lateral_speed": 0.0}


class Neighbour_Tracking:
    """Takes the nearest vehicle for the neighbour."""

    def execute(self, x, y, speed, lateral_speed, length, width):
        """Take sequences in m and m/s; return the distances from body to body in m, and speeds in m/s."""
        if len(x) == 0:
            return NOBODY
        return {
            "ahead": x[0] >= 0.0,
            "distance_along": abs(x[0]) - (LENGTH + length[0]) / 2,
            "distance_across": abs(y[0]) - (WIDTH + width[0]) / 2,
            "speed": speed[0],
            "lateral_speed": -lateral_speed[0] if y[0] > 0.0 else lateral_speed[0],
        }
