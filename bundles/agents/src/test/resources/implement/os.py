import os


class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": float(os.environ.get("LIMIT", "1000"))}
