from __future__ import annotations

import math
from collections import deque
from typing import TYPE_CHECKING

import numpy as np
from numpy.linalg import norm

if TYPE_CHECKING:
    from collections.abc import Sequence


class TTC:
    def execute(self, distance, speed):
        return {"ttc": float(norm(np.array([distance, math.hypot(speed, 0.0), len(deque())])))}
