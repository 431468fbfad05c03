class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": speed > 0.0}
