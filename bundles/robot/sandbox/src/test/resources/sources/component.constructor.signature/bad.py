class TTC:
    def __init__(self, gain):
        self.gain = gain

    def execute(self, distance, speed):
        return {"ttc": distance * self.gain}
