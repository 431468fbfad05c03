class Example:
    def __init__(self):
        self._count = 0
        self._past = []

    def execute(self, speed):
        self._count = self._count + int(speed)
        self._past.append(speed)
        self._past[0], mean = speed, speed
        previous = self._past
        previous.append(speed)
        return {"count": mean}
