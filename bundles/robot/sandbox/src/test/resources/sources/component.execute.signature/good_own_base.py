from abc import ABC


class Filter(ABC):
    def execute(self, distance, speed):
        return {"ttc": self.filtered(distance)}


class Unused:
    pass


class TTC(Unused, Filter):
    def filtered(self, value):
        return value
