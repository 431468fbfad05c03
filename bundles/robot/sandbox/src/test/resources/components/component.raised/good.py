class TTC:
    def execute(self, distance, speed):
        try:
            return {"ttc": distance / speed}
        except ZeroDivisionError:
            return {"ttc": 1000.0}
