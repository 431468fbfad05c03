class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": 10.0 % speed if speed == speed and abs(speed) < 1.0e30 else 1000.0}
