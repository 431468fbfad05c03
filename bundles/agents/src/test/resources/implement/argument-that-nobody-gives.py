class Time_Left:
    def execute(self, distances, speed, dt):
        return {"time_left": dt}
