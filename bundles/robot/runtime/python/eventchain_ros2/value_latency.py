"""Delay with which the outputs of a component answer the values of its inputs, by counterfactual replays.

The recorded calls of a component are repeated with a fresh one, and the value of one input is another one in a single
call: a pulse. The first call whose outputs differ from the recorded ones answers it. A delay inside a component answers
every pulse late. Filters, hysteresis and rate limits answer at once, and so does debouncing at the moment when its
output changes; a pulse that it suppresses has no answer at all.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from typing import Any, NamedTuple, Protocol

from component_client import ComponentError

HORIZON = 1_250_000_000
"""The time after a pulse, in ns, in which an answer is expected."""

MOST_CALLS = 10_000
"""Calls of a component in all of its replays; those with arrays count more."""

_FEWEST_REPLAYS = 10
_ELEMENTS = 500  # of arrays, that count as much as a call
_MOST_ELEMENTS = 2_000

_ONSETS = 4  # per output
_BEFORE = (0, 16, 32)  # calls before an onset, where a component may not yet have decided
_SPREAD = 8
_PART = 64  # calls at once

Inputs = dict[str, Any]
Pulse = Callable[[Any], Any]


class Component(Protocol):
    """A component that can begin again."""

    def make(self) -> None:
        """Forget all calls."""

    def series(self, calls: list[Inputs]) -> list[Any]:
        """Return the results of some calls."""

    def close(self) -> object:
        """End it."""


class Call(NamedTuple):
    """A recorded call of a component, at a time in ns."""

    time: int
    inputs: Inputs
    outputs: dict[str, Any]


class Record:
    """The calls of a component until one has more data than can be replayed, such as an image."""

    def __init__(self) -> None:
        self.calls: list[Call] = []
        self._ended = False

    def add(self, call: Call) -> None:
        """Add a call."""
        longest = MOST_CALLS // _FEWEST_REPLAYS
        self._ended = self._ended or len(self.calls) >= longest or _elements(call) > _MOST_ELEMENTS
        if not self._ended:
            self.calls.append(call)


class Answer(NamedTuple):
    """Answer of an output to a pulse of an input: the time of the pulse, and of the answer after it, in ns."""

    input: str
    output: str
    moment: int
    delay: int


def measure(calls: list[Call], start: Callable[[], Component]) -> list[Answer]:
    """Return the answers of a component's outputs to pulses of each input, until one came at once.

    A component that does not repeat itself is not measured: differences would say nothing about its inputs.

    Args:
        calls: the recorded calls, in the order of time.
        start: starts the component.

    """
    if len(calls) < 2:
        return []
    replays = _Replays(calls, start)
    try:
        if any(differing for _ in range(2) for _, differing in replays.of("", {})):
            return []
        moments = _rounds(replays.calls)
        return [answer for name in calls[0].inputs for answer in _Input(replays, name).answers(moments)]
    finally:
        replays.close()


class _Replays:
    """Replays of one component, with a common limit on its calls."""

    def __init__(self, calls: list[Call], start: Callable[[], Component]) -> None:
        self._weight = 1 + max(map(_elements, calls)) // _ELEMENTS
        self._left = MOST_CALLS // self._weight
        self.calls = calls[: self._left // _FEWEST_REPLAYS]
        self._start = start
        self._component = start()

    def close(self) -> None:
        """End the component."""
        self._component.close()

    def of(self, name: str, values: dict[int, Any]) -> Iterator[tuple[int, set[str]]]:
        """Yield each call's index and the outputs that differ; a value of an input counts until it is removed."""
        try:
            self._component.make()
            index = 0
            while index < len(self.calls) and self._left > 0:
                part = self.calls[index : self._end(index, values)]
                results = self._component.series([self._inputs(index + i, name, values) for i in range(len(part))])
                self._left -= len(part)
                for call, result in zip(part, results, strict=True):
                    yield index, _different(result, call.outputs)
                    index += 1
        except ComponentError:  # values that it never has may be more than it can take
            self._component.close()
            self._component = self._start()

    def _end(self, index: int, values: dict[int, Any]) -> int:
        """Return the end of a part that has no value but for its first call, unless all calls have one."""
        end = min(index + max(1, _PART // self._weight), len(self.calls))
        return end if len(values) == len(self.calls) else min((i for i in values if index < i < end), default=end)

    def _inputs(self, index: int, name: str, values: dict[int, Any]) -> Inputs:
        inputs = self.calls[index].inputs
        return {**inputs, name: values[index]} if index in values else inputs


class _Input:
    """Pulses of one input."""

    def __init__(self, replays: _Replays, name: str) -> None:
        self._replays = replays
        self._name = name
        self._recorded = [call.inputs[name] for call in replays.calls]
        self._pulses = _pulses(self._recorded)
        self._answers: list[Answer] = []

    def answers(self, rounds: list[list[int]]) -> list[Answer]:
        """Return the answers to pulses at these calls, round by round."""
        open_outputs = self._influenced()
        for moments in rounds:
            for pulse in self._pulses:
                rest = moments
                while rest and open_outputs:
                    rest = self._after_first(rest, pulse, open_outputs)
        return self._answers

    def _values(self, indices: Iterable[int], pulse: Pulse) -> dict[int, Any]:
        values = {index: pulse(self._recorded[index]) for index in indices}
        return {index: value for index, value in values.items() if not _same(value, self._recorded[index])}

    def _influenced(self) -> set[str]:
        """Return the outputs that differ if the input is another one all the time."""
        influenced: set[str] = set()
        outputs = self._replays.calls[0].outputs.keys()
        for pulse in self._pulses:
            values = {index: pulse(value) for index, value in enumerate(self._recorded)}
            for _, differing in self._replays.of(self._name, values):
                influenced |= differing
                if influenced >= outputs:
                    return influenced
        return influenced

    def _after_first(self, moments: list[int], pulse: Pulse, open_outputs: set[str]) -> list[int]:
        """Replay with pulses until one is answered; return the moments after it."""
        calls = self._replays.calls
        values = self._values(moments, pulse)
        if not values:
            return []
        found: dict[str, int] = {}
        pulsed, last, differing = -1, max(values), set[str]()
        for index, differing in self._replays.of(self._name, values):
            pulsed = index if index in values else pulsed
            delay = calls[index].time - calls[pulsed].time if pulsed >= 0 else 0
            if pulsed >= 0 and delay <= HORIZON and differing:
                found = {**dict.fromkeys(sorted(differing), delay), **found}
                values.clear()  # no further pulse
            if found.keys() >= open_outputs or (delay > HORIZON and (found or differing or index > last)):
                break
        moment = calls[pulsed].time
        self._answers += [Answer(self._name, output, moment, delay) for output, delay in found.items()]
        open_outputs -= {output for output, delay in found.items() if delay == 0}
        return [each for each in moments if each > pulsed] if found or differing else []


def _rounds(calls: list[Call]) -> list[list[int]]:
    """Return the indices of calls for pulses: in each round, with time for an answer between two of them."""
    left = _moments(calls)
    rounds: list[list[int]] = []
    while left:
        taken: list[int] = []
        for index in left:
            if not taken or calls[index].time - calls[taken[-1]].time > HORIZON:
                taken.append(index)
        rounds.append(taken)
        left = [index for index in left if index not in taken]
    return rounds


def _moments(calls: list[Call]) -> list[int]:
    """Return where an output begins to change, some calls before, and places in between."""
    moments = {len(calls) * (2 * place + 1) // (2 * _SPREAD) for place in range(_SPREAD)}
    for key in calls[0].outputs:
        changes = [not _same(one.outputs.get(key), other.outputs.get(key)) for one, other in pairwise(calls)]
        onsets = [index + 1 for index, changed in enumerate(changes) if changed and not (index and changes[index - 1])]
        for onset in onsets[:: max(1, -(-len(onsets) // _ONSETS))]:
            moments.update(max(0, onset - before) for before in _BEFORE)
    return sorted(moments)


def _pulses(recorded: list[Any]) -> list[Pulse]:
    """Return what to make of a value: negate it, or set its numbers to the least, the most, or others."""
    if all(isinstance(value, bool) for value in recorded):
        return [lambda value: not value]
    numbers = [number for value in recorded for number in _numbers(value) if math.isfinite(number)]
    if not numbers:
        return []
    least, most = min(numbers), max(numbers)
    others = (least, most) if least < most else (2 * abs(most) + 1, -2 * abs(most) - 1)
    return [_setting(number) for number in others]


def _elements(call: Call) -> int:
    return sum(len(value) if hasattr(value, "__len__") else 1 for value in call.inputs.values())


def _numbers(value: Any) -> list[Any]:
    """Return the number, or the numbers of an array; none if it is anything else."""
    each = value if isinstance(value, list) else value.tolist() if hasattr(value, "tolist") else [value]
    return each if all(isinstance(number, int | float) for number in each) else []


def _setting(number: float) -> Pulse:
    """Return a function that replaces each number of a value, whose type and length it keeps."""

    def replaced(value: Any) -> Any:
        try:
            if isinstance(value, array):
                return array(value.typecode, [_like(each, number) for each in value])
            if isinstance(value, list):
                return [_like(each, number) for each in value]
            return _like(value, number) if isinstance(value, int | float) else _filled(value, number)
        except OverflowError:
            return value

    return replaced


def _like(value: Any, number: float) -> Any:
    return round(number) if isinstance(value, int) else float(number)


def _filled(value: Any, number: float) -> Any:
    """Return a NumPy array of this shape with one number."""
    filled = value.copy()
    filled.fill(number)
    return filled


def _different(result: Any, outputs: dict[str, Any]) -> set[str]:
    got = result if isinstance(result, dict) else {}
    return {key for key, value in outputs.items() if not _same(got.get(key), value)}


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and one != one:
        return isinstance(other, float) and other != other
    if hasattr(one, "tolist") and hasattr(other, "tolist"):
        return _same(one.tolist(), other.tolist())
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    return bool(one == other)
