from __future__ import annotations

import collections.abc
import enum
import operator
from collections import namedtuple
from dataclasses import dataclass, field, replace
from enum import Enum, auto
from functools import partial, reduce
from statistics import fmean
from typing import NamedTuple, Optional

import numpy as np
import numpy.linalg as algebra
from numpy import linalg
from numpy.lib.stride_tricks import sliding_window_view

Point = namedtuple("Point", "x y")


class Mode(Enum):
    OFF = auto()
    ON = auto()


class Level(enum.IntEnum):
    LOW = 1


class Sample(NamedTuple):
    value: float = 0.0


@dataclass
class State:
    past: list[float] = field(default_factory=list)
    mode: Optional[Mode] = None


class TTC:
    def __init__(self):
        self.state = State()

    def execute(self, distance, speed):
        self.state = replace(self.state, mode=Mode(2))
        values = np.array([distance, speed, np.pi], dtype=np.float64)
        windows = sliding_window_view(values, 2).sum() + np.add.reduce(values)
        total = reduce(operator.add, [1.0, Level(1)]) + partial(max, 1.0)(2.0) + fmean([1.0])
        sizes = linalg.norm(values) + algebra.norm(values) + np.linalg.norm(values) + np.fft.fft(values)[0].real
        sequence = isinstance(self.state.past, collections.abc.Sequence)
        match self.state.mode, Sample(1.0):
            case Mode.ON, Sample(value=number):
                total += number

        def inner(operator):
            return operator.x

        return {"ttc": float(windows + total + sizes + sequence + inner(Point(1, 2)))}
