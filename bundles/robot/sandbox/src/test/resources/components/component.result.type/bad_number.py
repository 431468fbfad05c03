class TTC:
    def execute(self, distance, speed):
        return 1.0
