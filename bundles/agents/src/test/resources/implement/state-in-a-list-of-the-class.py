class Time_Left:
    history = []

    def execute(self, distances, speed):
        self.history.append(0.0)
        return {"time_left": float(len(self.history))}
