class Time_Left:
    def __call__(self, distances, speed):
        return {"time_left": 1000.0}
