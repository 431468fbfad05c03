import ttc_utils


class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": ttc_utils.time_left(distances, speed)}
