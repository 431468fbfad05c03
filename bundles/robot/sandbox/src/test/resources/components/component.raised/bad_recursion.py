class TTC:
    def execute(self, distance, speed):
        return self.execute(distance, speed)
