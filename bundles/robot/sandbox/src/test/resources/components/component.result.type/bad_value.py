class TTC:
    def execute(self, distance, speed):
        return {"ttc": None if speed == 0.0 else {distance}}
