class TTC:
    def __init__(self, node, gain=1.0):
        self.gain = gain

    def execute(self, distance, speed):
        return {"ttc": self.gain}
