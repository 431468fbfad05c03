class Time_Left:
    def execute(self, distances, speed):
        while not speed > 0.0: speed = speed * 1.0
        return {"time_left": 1000.0}
