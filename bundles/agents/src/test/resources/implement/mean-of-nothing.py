class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": 0.0 * sum(d for d in distances if 0.0 <= d < 1.0e6) / len(distances)}
