from scipy.signal import medfilt


class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": float(medfilt(distances)[0])}
