class TTC:
    def execute():
        return {"ttc": 1.0}
