class TTC:
    def execute(self, distance, speed, gain, *, offset=0.0, limit):
        return {"ttc": distance / speed}
