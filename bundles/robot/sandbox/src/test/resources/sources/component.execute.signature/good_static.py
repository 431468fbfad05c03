class TTC:
    @staticmethod
    def execute(speed, distance, gain=1.0):
        return {"ttc": distance}
