class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": speed * 1.0e300 if speed > 1.0e30 and speed < 1.0e39 else 1000.0}
