class TTC:
    def execute(self, distance, speed):
        return {"ttc": len([0.0] * 10**9)}
