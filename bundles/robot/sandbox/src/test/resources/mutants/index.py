class Example:
    def __init__(self):
        self._past = []

    def execute(self, ranges):
        first = ranges[0] + ranges[-2] + max(ranges[1:])
        for i in range(len(ranges)):
            first = min(first, ranges[i])
        return {"nearest": first, "oldest": self._past.pop(0), "table": {"a": first}["a"]}
