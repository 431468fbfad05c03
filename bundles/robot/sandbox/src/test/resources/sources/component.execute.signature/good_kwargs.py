class TTC:
    def execute(self, *args, gain=1.0, **inputs):
        return {"ttc": inputs["distance"]}
