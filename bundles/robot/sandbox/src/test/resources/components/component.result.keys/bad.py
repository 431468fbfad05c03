class TTC:
    def execute(self, distance, speed):
        if speed > 0.0:
            return {"ttc": distance / speed}
        return {"TTC": 1000.0, "valid": False}
