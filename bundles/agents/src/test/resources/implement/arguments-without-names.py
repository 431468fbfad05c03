class Time_Left:
    def execute(self, *args):
        return {"time_left": 1000.0}
