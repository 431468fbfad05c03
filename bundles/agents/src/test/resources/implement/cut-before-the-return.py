class Time_Left:
    """Time until the distance is used up."""

    def execute(self, distances, speed):
        valid = [d for d in distances if d > 0.0]
