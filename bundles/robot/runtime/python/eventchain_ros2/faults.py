"""Faults of nodes and of what they publish, in simulated time: one fault in a run, from its start on until its end.

A fault decides what depends on time and names alone, so that hosts of one node each and a host of all of them agree.
"""

from __future__ import annotations

import random
from typing import Any

NEVER = 1 << 62
"""A time, in ns, at which nothing happens any more."""

_CDR_HEADER = 4
_BYTES_FOR_ONE = 16  # of a message, so many for each that is changed


class Fault:
    """A fault that does nothing; each kind overrides what it changes.

    Args:
        target: name of a node or a topic.
        start: from when on, in ns.
        end: until when, in ns; that time is no longer part of it.
        amount: what the kind says: ns, a number of messages, or parts of a million.
        seed: of what is random.

    """

    def __init__(self, target: str, start: int, end: int, amount: int, seed: int) -> None:
        self.target = target
        self.start = start
        self.end = end
        self.amount = amount
        self.affected: dict[str, tuple[int, int]] = {}
        self._random = random.Random(seed)

    def touch(self, process: str, time: int) -> None:
        """Count something of a process that the fault changed at this time."""
        count, first = self.affected.get(process, (0, NEVER))
        self.affected[process] = count + 1, min(first, time)

    def is_active(self, time: int) -> bool:
        """Whether there is something wrong at this time."""
        return self.start <= time < self.end

    def free(self, process: str, time: int) -> int:
        """When the process may run a callback that could run at this time."""
        return time

    def ended(self, process: str, start: int, end: int) -> int:
        """When an activation ends that would do so at this time."""
        return end

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """What gets onto the topic of something that the process publishes: nothing, or messages one after another."""
        return [data]

    def clock(self, process: str, now: int) -> int:
        """What the clock of the process shows."""
        return now


class Pause(Fault):
    """A process is stopped, and goes on at the end; if that never comes, it was killed."""

    def free(self, process: str, time: int) -> int:
        """Nothing runs meanwhile."""
        if process != self.target or not self.is_active(time):
            return time
        self.touch(process, time)
        return self.end

    def ended(self, process: str, start: int, end: int) -> int:
        """What was not done at the start takes as much longer."""
        if process != self.target or not start < self.start <= end:
            return end
        self.touch(process, self.start)
        return min(end + self.end - self.start, NEVER)


class Delay(Fault):
    """Each activation of a process takes longer."""

    def __init__(self, target: str, start: int, end: int, amount: int, seed: int) -> None:
        super().__init__(target, start, end, amount, seed)
        self._last = -1

    def ended(self, process: str, start: int, end: int) -> int:
        """It is the start that counts."""
        if process != self.target or not self.is_active(start):
            return end
        if start != self._last:  # and not each time that somebody asks
            self._last = start
            self.touch(process, start)
        return end + self.amount


class Flood(Fault):
    """Everything that a process publishes is published several times more."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """At the same time, on the same topic."""
        if not self.concerns(process, topic) or not self.is_active(time):
            return [data]
        self.touch(process, time)
        return [data] * (1 + self.amount)

    def concerns(self, process: str, topic: str) -> bool:
        """Whether it is published too often."""
        return process == self.target


class Repeat(Flood):
    """Every message on a topic that a node publishes comes several times more."""

    def concerns(self, process: str, topic: str) -> bool:
        """The world, whose process has no name, sees to its own messages."""
        return process != "" and topic == self.target


class Drop(Repeat):
    """Messages on a topic get lost."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """A share of them, in parts of a million."""
        if not self.concerns(process, topic) or not self.is_active(time):
            return [data]
        if self._random.random() * 1_000_000 >= self.amount:
            return [data]
        self.touch(process, time)
        return []


class Corrupt(Repeat):
    """Messages on a topic come with other bytes."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """The header says how to read the rest and stays; what cannot be decoded any more is lost on the way."""
        if not self.concerns(process, topic) or not self.is_active(time) or len(data) <= _CDR_HEADER:
            return [data]
        self.touch(process, time)
        changed = bytearray(data)
        length = len(changed) - _CDR_HEADER
        for _ in range(1 + length // _BYTES_FOR_ONE):
            place = _CDR_HEADER + int(self._random.random() * length)
            changed[place] ^= 1 + int(self._random.random() * 255)
        return [bytes(changed)]


class ClockJump(Fault):
    """All clocks show another time. Timers keep their periods, as with a clock that is never set."""

    def clock(self, process: str, now: int) -> int:
        """Earlier or later."""
        if not self.is_active(now):
            return now
        self.touch(process, now)
        return now + self.amount


_KINDS: dict[str, type[Fault]] = {
    "kill": Pause,
    "stop": Pause,
    "delay": Delay,
    "flood": Flood,
    "drop": Drop,
    "repeat": Repeat,
    "corrupt": Corrupt,
    "clock_jump": ClockJump,
}


def of(json: dict[str, Any] | None) -> Fault | None:
    """The fault of a configuration; None where there is none, or one of the world's."""
    if json is None or json["kind"] not in _KINDS:
        return None
    kind = _KINDS[json["kind"]]
    end = NEVER if json["end"] is None else json["end"]
    return kind(json["target"], json["start"], end, json["amount"], json["seed"])
