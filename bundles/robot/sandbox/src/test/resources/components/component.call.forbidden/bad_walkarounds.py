import enum
from enum import IntEnum
from functools import reduce

import numpy as np


class Mode(IntEnum):
    pass


class Meta(type):
    pass


def later(eval):
    return eval


class TTC:
    __array_interface__ = {"version": 3}
    value = eval("1")

    def __getattr__(self, name):
        return name

    def __reduce__(self):
        return len, ()

    def execute(self, distance, speed):
        "{0.__class__}".format(distance)
        "{0:{1.real}}".format(distance, speed)
        "{0[0]}".format([speed])
        text = "{}"
        text.format(self), str.format(text, self), text.format_map({}), "{}".format
        reduce(getattr, ["real"], distance)
        getattr(self, "__dict__"), getattr(self, "gi_frame"), getattr(self, text)
        (number for number in [1]).gi_frame.f_back.f_globals
        try:
            pass
        except ValueError as problem:
            problem.__traceback__.tb_frame.f_builtins
        type("X", (), {}), type(self, *[]), self.__class__.mro()
        Mode("X", [("__array_interface__", 1)]), enum.Enum("X", names="A B")
        np.array(["now"], dtype="datetime64[s]"), np.zeros(2).ctypes, np.zeros(2).tofile("f")
        match self:
            case object(gi_frame=frame):
                pass
        self.__class__ = Mode
        [open for open in [open]]
        global exec
        exec("1"), id(self), license, __file__
        return {"ttc": later(1.0)}
