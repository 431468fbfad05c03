class Time_Left:
    def execute(self, distances, speed):
        return {"ttc": 1000.0}
