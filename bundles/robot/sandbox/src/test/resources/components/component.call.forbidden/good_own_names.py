"""Names of Python's own as names of the component's own, and texts that are formatted."""


class TTC:
    __slots__ = ("values", "id")

    def __init__(self):
        self.values: dict[str, type[int]] = {}
        self.id = 0

    def __add__(self, other):
        return self

    def execute(self, distance, speed):
        id = [input for input in (distance, speed)]
        vars = lambda type, exec=1: type + exec
        text = "{:.2f} {name:>{width}}".format(distance, name="x", width=4) + f"{speed:{'.1f'}}"
        kind = type(self).__name__ if isinstance(self, type) else self.__class__.__name__
        return {"ttc": float(len(text) + len(kind) + vars(1) + len(id) + getattr(self, "id", 0))}
