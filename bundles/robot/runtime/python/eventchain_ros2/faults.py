"""Faults of nodes and topics in simulated time: one fault per run, from its start to its end.

A fault depends on time and names only, so that hosts of single nodes and a host of all nodes agree.
"""

from __future__ import annotations

import random
from typing import Any

NEVER = 1 << 62
"""A time, in ns, at which nothing happens any more."""

_CDR_HEADER = 4
_BYTES_FOR_ONE = 16  # bytes of a message per changed byte


class Fault:
    """A fault without effect; each kind overrides the methods that it changes.

    Args:
        target: name of a node or a topic.
        start: start time, in ns.
        end: end time, in ns, exclusive.
        amount: magnitude, depending on the kind: ns, a number of messages, or parts per million.
        seed: seed of random choices.

    """

    def __init__(self, target: str, start: int, end: int, amount: int, seed: int) -> None:
        self.target = target
        self.start = start
        self.end = end
        self.amount = amount
        self.affected: dict[str, tuple[int, int]] = {}
        self._random = random.Random(seed)

    def touch(self, process: str, time: int) -> None:
        """Count an effect of the fault on a process at this time."""
        count, first = self.affected.get(process, (0, NEVER))
        self.affected[process] = count + 1, min(first, time)

    def is_active(self, time: int) -> bool:
        """Return whether the fault is active at this time."""
        return self.start <= time < self.end

    def free(self, process: str, time: int) -> int:
        """Return when the process may run a callback that is ready at this time."""
        return time

    def ended(self, process: str, start: int, end: int) -> int:
        """Return when an activation ends that would end at this time."""
        return end

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """Return the messages on the topic for one published message: none, one or several."""
        return [data]

    def visible(self, process: str, topic: str, time: int) -> int:
        """Return when others see a message that is published at this time; in a host of all nodes only."""
        return time

    def clock(self, process: str, now: int) -> int:
        """Return the time on the clock of the process."""
        return now


class Pause(Fault):
    """A process is stopped, and continues at the end of the fault; without an end, it was killed."""

    def free(self, process: str, time: int) -> int:
        """Return the end of the pause: no callback runs before."""
        if process != self.target or not self.is_active(time):
            return time
        self.touch(process, time)
        return self.end

    def ended(self, process: str, start: int, end: int) -> int:
        """Return the end extended by the pause."""
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
        """Return the end extended by the delay, if the activation starts within the fault."""
        if process != self.target or not self.is_active(start):
            return end
        if start != self._last:  # only once per activation
            self._last = start
            self.touch(process, start)
        return end + self.amount


class Flood(Fault):
    """Every message that a process publishes is repeated several times."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """Return the repeated messages, at the same time, on the same topic."""
        if not self.concerns(process, topic) or not self.is_active(time):
            return [data]
        self.touch(process, time)
        return [data] * (1 + self.amount)

    def concerns(self, process: str, topic: str) -> bool:
        """Return whether messages of the process on the topic are repeated."""
        return process == self.target


class Repeat(Flood):
    """Every message that a node publishes on a topic is repeated several times."""

    def concerns(self, process: str, topic: str) -> bool:
        """Exclude the world, whose process has no name: it repeats its own messages."""
        return process != "" and topic == self.target


class Drop(Repeat):
    """Messages on a topic are lost."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """Drop a share of the messages, in parts per million."""
        if not self.concerns(process, topic) or not self.is_active(time):
            return [data]
        if self._random.random() * 1_000_000 >= self.amount:
            return [data]
        self.touch(process, time)
        return []


class Corrupt(Repeat):
    """Messages on a topic have changed bytes."""

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """Change bytes after the encapsulation header; a message that can no longer be decoded is lost."""
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
    """All clocks are offset. Timers keep their periods, as with a monotonic clock."""

    def clock(self, process: str, now: int) -> int:
        """Return the time with its offset."""
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
    """Return the fault of a configuration; None if there is none, or if the world applies it."""
    if json is None or json["kind"] not in _KINDS:
        return None
    kind = _KINDS[json["kind"]]
    end = NEVER if json["end"] is None else json["end"]
    return kind(json["target"], json["start"], end, json["amount"], json["seed"])
