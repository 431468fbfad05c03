"""Standard faults of an output: what a node publishes on a topic is wrong, late or missing, from the start to the end.

They measure how sharp the criteria of a scenario are. A fault of a value changes one field of the messages, a number, a
Boolean, or each number of an array; the others concern whole messages, whose headers stay as they are.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from eventchain_ros2.faults import NEVER, Fault
from eventchain_ros2.messages import from_cdr, to_cdr

_HEADER = "header"


class OutputFault(Fault):
    """A fault of the messages of a node on a topic.

    Args:
        json: its configuration; `amount` depends on the kind: ms, a number of messages, a value, a factor or a shift.
        message_class: class of the messages.

    """

    def __init__(self, json: dict[str, Any], message_class: type) -> None:
        super().__init__(json["target"], 0, NEVER, 0, json["seed"])
        self._topic: str = json["topic"]
        self._class = message_class
        self.value = float(json["amount"])

    def concerns(self, process: str, topic: str) -> bool:
        """Return whether the fault is in the messages of this node on this topic."""
        return process == self.target and topic == self._topic

    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        """Return the message as the fault leaves it."""
        if not self.concerns(process, topic):
            return [data]
        changed = bytes(self.changed(data))
        if changed == bytes(data):
            return [data]
        self.touch(process, time)
        return [changed]

    def changed(self, data: Any) -> Any:
        """Return the encoded message as the fault leaves it."""
        return data


class _Dropped(OutputFault):
    def sent(self, process: str, topic: str, time: int, data: Any) -> list[Any]:
        if not self.concerns(process, topic):
            return [data]
        self.touch(process, time)
        return []


class _Delayed(OutputFault):
    def visible(self, process: str, topic: str, time: int) -> int:
        if not self.concerns(process, topic):
            return time
        self.touch(process, time)
        return time + round(self.value * 1e6)


class _Held(OutputFault):
    """Only every n-th message has new content; without a number, only the first."""

    _count = 0
    _kept: Any = None

    def changed(self, data: Any) -> Any:
        message = from_cdr(self._class, data)
        if self._kept is None or (self.value and self._count % int(self.value) == 0):
            self._kept = message
        self._count += 1
        if message is self._kept:
            return data
        repeated = from_cdr(self._class, to_cdr(self._kept))
        if hasattr(message, _HEADER):
            setattr(repeated, _HEADER, getattr(message, _HEADER))
        return to_cdr(repeated)


class _Value(OutputFault):
    """A fault of one field."""

    def __init__(self, json: dict[str, Any], message_class: type) -> None:
        super().__init__(json, message_class)
        *self._owners, self._name = json["field"].split(".")
        self._alter: Callable[[Any], Any] = getattr(self, "_" + json["change"])
        self._range: list[float] | None = json.get("range")
        self._initial: Any = None

    def changed(self, data: Any) -> Any:
        message = owner = from_cdr(self._class, data)
        for each in self._owners:
            owner = getattr(owner, each)
        value = getattr(owner, self._name)
        if isinstance(value, bool | int | float | str):
            setattr(owner, self._name, self._fitting(value))
        else:
            numbers = value.tolist() if hasattr(value, "tolist") else value
            setattr(owner, self._name, [self._fitting(each) for each in numbers])
        return to_cdr(message)

    def _fitting(self, value: Any) -> Any:
        """Return the altered value, of the same type and within its range."""
        altered = self._alter(value)
        if isinstance(value, bool | str) or not math.isfinite(altered):
            return altered
        if self._range is not None:
            altered = min(max(altered, self._range[0]), self._range[1])
        return float(altered) if isinstance(value, float) else round(altered)

    def _first(self, value: Any) -> Any:
        if self._initial is None:
            self._initial = value
        return self._initial

    def _stuck(self, value: Any) -> Any:
        return self.value != 0 if isinstance(value, bool) else self.value

    def _negated(self, value: Any) -> Any:
        return not value

    def _inverted(self, value: Any) -> Any:
        return -value

    def _scaled(self, value: Any) -> Any:
        return value * self.value

    def _shifted(self, value: Any) -> Any:
        return value + self.value

    def _noisy(self, value: Any) -> Any:
        return value + self.value * (2 * self._random.random() - 1)


_KINDS: dict[str, type[OutputFault]] = {
    "dropped": _Dropped,
    "delayed": _Delayed,
    "held": _Held,
    "first": _Held,
}


def of(json: dict[str, Any] | None, message_class: Callable[[str], type]) -> OutputFault | None:
    """Return the fault of a configuration; None if there is none, or if it is not one of an output."""
    if json is None or json["kind"] != "output":
        return None
    kind = _Value if json["field"] else _KINDS[json["change"]]
    return kind(json, message_class(json["type"]))
