class Example:
    def execute(self, valid, speed, distance):
        if valid and speed > 0.0:
            time = distance / speed
        else:
            time = 1000.0
        return {"time": time if distance > 0.0 else 0.0}
