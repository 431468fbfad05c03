class Time_Left:
    def execute(self, distances, speed, seen=[]):
        seen.append(0.0)
        return {"time_left": float(len(seen))}
