calls = 0


class TTC:
    def execute(self, distance, speed):
        global calls
        calls += 1
        return {"ttc": float(calls)}
