"""Delays of values within a component are found; filters, hysteresis and debouncing are none."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from itertools import count
from typing import Any

import pytest
from component_client import ComponentError
from eventchain_ros2.value_latency import Call, Record, measure

PERIOD = 20_000_000
DELAY = 15

Execute = Callable[[dict[str, Any]], dict[str, Any]]
Component = Callable[[], Execute]


class Process:
    """A component that is called where it is."""

    def __init__(self, component: Component) -> None:
        self._component = component
        self._execute = component()

    def make(self) -> None:
        self._execute = self._component()

    def series(self, calls: list[dict[str, Any]]) -> list[Any]:
        return [self._execute(inputs) for inputs in calls]

    def close(self) -> None:
        """Nothing has to be ended."""


def recorded(component: Component, length: int = 400) -> list[Call]:
    """Return the calls of a drive towards an object, which comes near twice."""
    execute = component()
    calls = []
    for index in range(length):
        distance = 60 - 0.3 * (index % 200) + 0.1 * math.sin(index)
        inputs = {"present": 60 < index % 200 < 190, "distance": distance, "spare": 0.0}
        calls.append(Call(index * PERIOD, inputs, execute(inputs)))
    return calls


def delays(component: Component, name: str = "distance", output: str = "brake") -> list[float]:
    """Return the delays of an output's answers, in ms."""
    found = measure(recorded(component), lambda: Process(component))
    return [answer.delay / 1e6 for answer in found if (answer.input, answer.output) == (name, output)]


def plain() -> Execute:
    return lambda inputs: {"brake": 1.0 if inputs["present"] and inputs["distance"] < 30 else 0.0}


def late_inputs() -> Execute:
    decide, kept = plain(), deque([{"present": False, "distance": 60.0}] * DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        kept.append(inputs)
        return decide(kept.popleft())

    return execute


def late_distance() -> Execute:
    decide, kept = plain(), deque([60.0] * DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        kept.append(inputs["distance"])
        return decide({**inputs, "distance": kept.popleft()})

    return execute


def late_output() -> Execute:
    decide, kept = plain(), deque([{"brake": 0.0}] * DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        kept.append(decide(inputs))
        return kept.popleft()

    return execute


def late_output_that_latches() -> Execute:
    latched, kept = [False], deque([0.0] * DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        latched[0] = inputs["present"] and (latched[0] or inputs["distance"] < 30)
        kept.append(1.0 if latched[0] else 0.0)
        return {"brake": kept.popleft()}

    return execute


def low_pass() -> Execute:
    state = [60.0]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        state[0] += 0.05 * (inputs["distance"] - state[0])
        return {"brake": 1.0 if inputs["present"] and state[0] < 30 else 0.0}

    return execute


def moving_average() -> Execute:
    kept: deque[float] = deque(maxlen=DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        kept.append(inputs["distance"])
        return {"brake": max(0.0, 1 - sum(kept) / len(kept) / 60) if inputs["present"] else 0.0}

    return execute


def median() -> Execute:
    kept: deque[float] = deque(maxlen=DELAY)

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        kept.append(inputs["distance"])
        return {"brake": 1.0 if inputs["present"] and sorted(kept)[len(kept) // 2] < 30 else 0.0}

    return execute


def hysteresis() -> Execute:
    brakes = [False]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        brakes[0] = inputs["present"] and inputs["distance"] < (35 if brakes[0] else 30)
        return {"brake": 1.0 if brakes[0] else 0.0}

    return execute


def debounce() -> Execute:
    times = [0]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        times[0] = times[0] + 1 if inputs["present"] and inputs["distance"] < 30 else 0
        return {"brake": times[0] >= DELAY}

    return execute


def up_and_down_counter() -> Execute:
    times = [0]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        near = inputs["present"] and inputs["distance"] < 30
        times[0] = max(0, min(DELAY, times[0] + (1 if near else -1)))
        return {"brake": times[0] == DELAY}

    return execute


def ramp() -> Execute:
    level = [0.0]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        wanted = 1.0 if inputs["present"] and inputs["distance"] < 30 else 0.0
        level[0] += max(-0.02, min(0.02, wanted - level[0]))
        return {"brake": level[0]}

    return execute


def hold() -> Execute:
    since = [1000]

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        since[0] = 0 if inputs["present"] and inputs["distance"] < 30 else since[0] + 1
        return {"brake": since[0] < DELAY}

    return execute


def every_fifth() -> Execute:
    calls, kept, decide = count(), [{"brake": 0.0}], plain()

    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        if next(calls) % 5 == 0:
            kept[0] = decide(inputs)
        return kept[0]

    return execute


@pytest.mark.parametrize("component", [late_inputs, late_distance, late_output, late_output_that_latches])
def test_a_delay_answers_every_pulse_late(component: Component) -> None:
    found = delays(component)
    assert min(found) == DELAY * PERIOD / 1e6
    assert found.count(min(found)) >= 3


@pytest.mark.parametrize(
    "component",
    [
        plain,
        low_pass,
        moving_average,
        median,
        hysteresis,
        debounce,
        up_and_down_counter,
        ramp,
        hold,
        every_fifth,
    ],
)
@pytest.mark.parametrize("name", ["distance", "present"])
def test_what_a_component_does_to_a_signal_is_no_delay(component: Component, name: str) -> None:
    assert 0.0 in delays(component, name)


def test_only_the_delayed_input_is_late() -> None:
    assert 0.0 in delays(late_distance, "present")


def test_an_input_without_influence_has_no_answers() -> None:
    assert delays(plain, "spare") == []


def test_what_does_not_repeat_itself_is_not_measured() -> None:
    numbers = count()
    assert delays(lambda: lambda inputs: {"brake": next(numbers)}) == []


def test_a_component_that_refuses_values_has_no_answers() -> None:
    def execute(inputs: dict[str, Any]) -> dict[str, Any]:
        if not 0 <= inputs["distance"] <= 61:
            raise ComponentError("component.raised", "out of range")
        return {"brake": 1.0 if inputs["present"] else 0.0}

    assert delays(lambda: execute) == []


def test_images_are_not_recorded() -> None:
    record = Record()
    for size in (10, 100_000, 10):
        record.add(Call(0, {"image": bytes(size)}, {"found": False}))
    assert len(record.calls) == 1
