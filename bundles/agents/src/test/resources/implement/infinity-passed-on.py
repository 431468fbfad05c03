class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": min(distances, default=1000.0)}
