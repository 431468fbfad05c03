from enum import sys
from math import *
from numpy import random, linalg as algebra
from operator import attrgetter, itemgetter
import collections, dataclasses, functools, operator, statistics, string, typing
import numpy as np
import numpy.random


class TTC:
    import math

    def execute(self, distance, speed):
        system = collections._sys
        operator.attrgetter("real"), operator.methodcaller("format", 1)
        noise = np.random.rand() + statistics.random.random()
        now = np.datetime64("now")
        np.load("f"), np.fromfile("f"), np.memmap("f"), np.lib.npyio, np.ctypeslib, np.testing, np.f2py
        typing.get_type_hints(self), dataclasses.make_dataclass("X", []), functools.singledispatch(len)
        functools.wraps(system, assigned=["gi_frame"]), string.Formatter(), np.emath.sqrt
        module = np
        self.module = np.linalg
        np.pi = 3
        return {"ttc": module.pi, "names": [np for np in (1, 2)]}
