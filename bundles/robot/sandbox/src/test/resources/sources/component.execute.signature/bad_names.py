class TTC:
    def execute(self, distance, velocity):
        return {"ttc": distance / velocity}
