class Time_Left:
    def execute(self, distances, speed):
        if speed < 0.0:
            return {"time_left": 1000.0}
        return {"time_left": 10.0 // speed if speed < 1.0e30 else 0.0}
