class TTC:
    def __init__(self):
        self.table = {}
        self.limit = self.table["limit"]

    def execute(self, distance, speed):
        return {"ttc": self.limit}
