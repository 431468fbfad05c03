"""Wrong on purpose: it is busy in native code, which nothing interrupts."""

from collections import deque
from itertools import repeat


class Braking_Decision:
    def execute(self, time_to_collision):
        deque(repeat(0.0), maxlen=0)
        return {"braking_force": 0.0}
