class TTC:
    def execute(self, distance, speed):
        if speed > 0.0:
            return {"ttc": distance / speed}
