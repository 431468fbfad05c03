class TTC:
    def execute(self, distance, speed):
        values = iter(())
        for _ in range(200_000):
            values = map(abs, values)
        return {"ttc": float(len(list(values)))}  # more calls inside each other than the stack can hold
