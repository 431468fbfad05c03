class Time_Left:
    def execute(self, distances, speed):
        closing = speed - 1.0
        return {"time_left": 10.0 / closing if closing == closing and abs(closing) < 1.0e30 else 1000.0}
