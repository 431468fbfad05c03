class Example:
    def execute(self, speed, gear, closed, known):
        reverse = gear == -1 or gear in known
        return {"fast": 5.0 < speed <= 13.9, "open": not closed, "reverse": reverse}
