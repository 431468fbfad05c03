class Example:
    def __init__(self):
        self._sum = 0

    def execute(self, left, right):
        self._sum += left
        return {"offset": -(left - right) / 2.5, "name": "a" + "b"}
