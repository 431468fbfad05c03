class TTC:
    def run(self, distance, speed):
        return {"ttc": distance}
