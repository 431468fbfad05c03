class TTC:
    @staticmethod
    def execute(speed, distance, *, minimum=0.1, **others):
        return {"ttc": distance / max(speed, minimum)}
