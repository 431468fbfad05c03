class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": 1000.0 if speed > 0.0 else None}
