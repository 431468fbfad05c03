class Time_Left:
    def execute(distances, speed):
        return {"time_left": 1000.0}
