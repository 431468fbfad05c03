class TTC:
    def execute(self, distance, speed):
        return {"ttc": self.divide(distance, speed)}

    def divide(self, distance, speed):
        return distance / speed
