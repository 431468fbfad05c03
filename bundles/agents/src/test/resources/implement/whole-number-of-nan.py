class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": float(int(speed)) if abs(speed) < 1.0e30 or speed != speed else 1000.0}
