class TTC:
    def __init__(self):
        super().__init__()
        self.open = 0

    def execute(self, distance, speed):
        open = distance > 1.0
        print("distance", distance, type(self).__name__)
        return {"ttc": float(open) + getattr(self, "open", 0)}
