GAIN = 0.02
"""rad per metre: 0.02."""
COUNT = 5
LARGE = 200
ZERO = 0.0


class Example:
    def __init__(self, gain=0.3):
        self._gain = gain

    def execute(self, offset):
        return {"angle": GAIN * offset, "reverse": False}
