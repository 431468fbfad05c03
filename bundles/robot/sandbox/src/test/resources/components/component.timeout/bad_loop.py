class TTC:
    def execute(self, distance, speed):
        while speed < distance: speed += 0.0
        return {"ttc": speed}
