class TTC:
    def execute(self, distance, speed):
        return {"ttc": max(distance, (speed}
