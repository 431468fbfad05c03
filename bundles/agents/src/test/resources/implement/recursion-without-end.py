class Time_Left:
    def execute(self, distances, speed):
        return self.execute(distances, speed)
