class Time_Left:
    def execute(self, distances, speed):
        while speed < 0.0:
            pass
        return {"time_left": 1000.0}
