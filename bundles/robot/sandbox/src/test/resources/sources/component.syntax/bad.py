class TTC:
    def execute(self, distance, speed)
        return {"ttc": distance / speed}
