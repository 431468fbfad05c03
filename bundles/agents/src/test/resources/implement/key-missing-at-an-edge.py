class Time_Left:
    def execute(self, distances, speed):
        result = {}
        if speed >= 0.0:
            result["time_left"] = 1000.0
        return result
