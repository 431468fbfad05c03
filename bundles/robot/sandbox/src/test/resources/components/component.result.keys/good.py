class TTC:
    def execute(self, distance, speed):
        return dict(ttc=1.0)
