from helper import LIMIT


class TTC:
    def execute(self, distance, speed):
        return {"ttc": min(distance, LIMIT)}
