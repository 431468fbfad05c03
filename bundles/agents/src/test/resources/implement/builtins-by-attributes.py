class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": float(len(().__class__.__base__.__subclasses__()))}
