class TTC:
    def execute(self, distance, speed):
        if speed <= 0:
            return {"TTC": 100.0}
        return {"ttc": distance / speed, "valid": True}
