class TTC:
    def execute(self, distance, speed):
        if speed <= 0:
            return
        return {"ttc": distance / speed}
