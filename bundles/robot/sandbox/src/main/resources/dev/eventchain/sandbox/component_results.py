"""Checks of a component's result: a dict with exactly its outputs, each of the declared type."""

from __future__ import annotations

import math
from array import array
from collections.abc import Collection
from typing import Any, NamedTuple

_INTEGERS = frozenset({f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)} | {"char"})
_NUMBERS = _INTEGERS | {"float", "float32", "float64", "double"}
_TRUTHS = frozenset({"bool", "boolean"})
_FLOATS = frozenset({float})

VALUE_HINT = "Return a number, a truth value, a string, or a list of these."


class Output(NamedTuple):
    """An output: the key in the dict, and its declared type, or "" for any."""

    name: str
    type: str = ""


class Problem(NamedTuple):
    """A problem of a result: the rule's id, a sentence without its subject `execute()`, and a hint."""

    rule: str
    message: str
    hint: str


def keys_hint(outputs: list[Output]) -> str:
    """Return the hint for the keys."""
    return f"Return a dict with exactly these keys: {', '.join(output.name for output in outputs)}."


def check(values: Any, outputs: list[Output]) -> list[Problem]:
    """Check the value that `execute` returned."""
    if type(values) is not dict:
        expected = keys_hint(outputs)
        return [Problem("component.result.type", f"returned {type(values).__name__}, not dict", expected)]
    wrong = check_keys(values, outputs)
    return wrong or [
        problem
        for output in outputs
        if not _is_usual(output.type, values[output.name])
        for problem in _check_output(output, values[output.name])
    ]


def check_keys(keys: Collection[Any], outputs: list[Output]) -> list[Problem]:
    """Check the keys of the dict that `execute` returns."""
    names = [output.name for output in outputs]
    if list(keys) == names:
        return []
    missing = [name for name in names if name not in keys]
    extra = [str(key) for key in keys if key not in names]
    if not missing and not extra:
        return []
    parts = [f"{word} {', '.join(keys)}" for word, keys in (("without", missing), ("with", extra)) if keys]
    return [Problem("component.result.keys", f"returned a dict {' and '.join(parts)}", keys_hint(outputs))]


def _is_usual(declared: str, value: Any) -> bool:
    """Return whether the value is a finite number or a truth value as declared: most are, at each step."""
    kind = type(value)
    if kind is float:
        return -math.inf < value < math.inf and declared in _NUMBERS
    return declared in _NUMBERS if kind is int else kind is bool and declared in _TRUTHS


def _check_output(output: Output, value: Any) -> list[Problem]:
    name, declared = output
    if value is None or isinstance(value, dict):
        return [Problem("component.result.type", f"returned {type(value).__name__} for '{name}'", VALUE_HINT)]
    if declared in _NUMBERS and (isinstance(value, bool) or not isinstance(value, (int, float))):
        hint = f"Return a number: '{name}' is declared as {declared}."
        return [Problem("component.result.type", f"returned {_shown(value)} for '{name}'", hint)]
    kinds = _kinds(declared)
    if kinds and not isinstance(value, kinds[1:]) and not (kinds[0] == "a sequence" and hasattr(value, "tolist")):
        hint = f"Return {kinds[0]}: '{name}' is declared as {declared}."
        return [Problem("component.result.type", f"returned {_shown(value)} for '{name}'", hint)]
    if isinstance(value, float) and not math.isfinite(value):
        hint = "Return a finite number in every case."
        return [Problem("component.result.nan", f"returned {value} for '{name}'", hint)]
    if isinstance(value, (list, array)) or hasattr(value, "tolist"):
        return _check_elements(name, value)
    return []


def _kinds(declared: str) -> tuple[Any, ...]:
    """Return the name of a declared type and the Python types that it accepts; empty for any."""
    if declared.endswith("]"):
        return "a sequence", list, tuple, array, bytes, bytearray
    if declared in _TRUTHS:
        return "a truth value", bool, int
    return ("a text", str) if declared.partition("<")[0] == "string" else ()


def _check_elements(name: str, values: Any) -> list[Problem]:
    """Check the elements of a sequence, which may be infinite, as in a laser scan: nothing in range (REP 117)."""
    if not isinstance(values, list):
        total = sum(values) if isinstance(values, array) else values.sum()
        if total == total:  # NaN propagates to the sum
            return []
        values = values.tolist()
    elif _FLOATS.issuperset(map(type, values)) and not math.isnan(sum(values)):
        return []
    for index, element in enumerate(values):
        if element is None:
            hint = "Return a number for each element."
            return [Problem("component.result.type", f"returned None in '{name}' at index {index}", hint)]
        if type(element) is float and element != element:
            hint = "Use infinity for 'nothing there', as a laser scan does."
            return [Problem("component.result.nan", f"returned nan in '{name}' at index {index}", hint)]
    return []


def _shown(value: Any) -> str:
    return f"the {type(value).__name__} {value!r}"[:80] if isinstance(value, (bool, str)) else type(value).__name__
