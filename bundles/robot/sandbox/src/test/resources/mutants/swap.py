class Example:
    def execute(self, left, right, speed):
        """Take m and m/s."""
        return {"offset": left, "past": right}
