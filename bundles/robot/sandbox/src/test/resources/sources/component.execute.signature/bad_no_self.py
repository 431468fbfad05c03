class TTC:
    def execute(distance, speed):
        return {"ttc": distance / speed}
