class Time_Left:
    """Time until the distance is used up.

    def execute(self, distances, speed):
        return {"time_left": 10