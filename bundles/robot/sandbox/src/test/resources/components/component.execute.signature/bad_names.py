class TTC:
    def execute(self, distance, velocity):
        return {"ttc": 1.0}
