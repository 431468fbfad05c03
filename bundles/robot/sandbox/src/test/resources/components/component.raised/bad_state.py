class TTC:
    def __init__(self):
        self.distances = []

    def execute(self, distance, speed):
        self.distances.append(distance)
        return {"ttc": distance / (2 - len(self.distances))}
