class TTC:
    def execute(distance, speed):
        return {"ttc": distance / max(speed, 0.1)}
