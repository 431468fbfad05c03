class Time_Left:
    def __init__(self, limit):
        self.limit = limit

    def execute(self, distances, speed):
        return {"time_left": self.limit}
