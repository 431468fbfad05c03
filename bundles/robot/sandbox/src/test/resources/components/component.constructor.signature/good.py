class TTC:
    def __init__(self, gain=1.0, *, offset=0.0):
        self.gain = gain + offset

    def execute(self, distance, speed):
        return {"ttc": self.gain}
