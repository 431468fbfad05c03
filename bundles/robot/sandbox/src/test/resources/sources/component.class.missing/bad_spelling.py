"""The class is called otherwise."""


class Ttc:
    def execute(self, distance, speed):
        return {"ttc": distance}
