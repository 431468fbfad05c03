"""Checks of what components return, around the components of nodes that run here.

Generated nodes are plain rclpy code without such checks, so the host puts them around the component object that it
finds on the node.
"""

from __future__ import annotations

import linecache
from array import array
from math import isfinite
from types import MethodType
from typing import Any

from eventchain_ros2.failures import HostError


class CheckedComponent:
    """Stands for a component on its node, and checks each result of its `execute`."""

    def __init__(self, component: Any, outputs: list[str] | None) -> None:
        object.__setattr__(self, "_component", component)
        object.__setattr__(self, "_outputs", None if outputs is None else frozenset(outputs))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._component, name)

    def __setattr__(self, name: str, value: Any) -> None:
        setattr(self._component, name, value)

    def execute(self, *arguments: Any, **inputs: Any) -> Any:
        """Execute the component.

        Raises:
            HostError: the result is not a dict with the expected keys, or a number in it is not finite.

        """
        result = self._component.execute(*arguments, **inputs)
        if type(result) is not dict:
            raise self._error("type", f"execute() has to return a dict, not {type(result).__name__}")
        if self._outputs is not None and result.keys() != self._outputs:
            raise self._error("keys", self._difference(result))
        for key, value in result.items():
            problem = _problem(value)
            if problem:
                raise self._error("type" if value is None else "nan", f"execute() returned {problem} for '{key}'")
        return result

    def _difference(self, result: dict[str, Any]) -> str:
        expected = self._outputs or frozenset()
        missing, extra = sorted(expected - result.keys()), sorted(map(str, result.keys() - expected))
        text = "execute() returned a dict with the wrong keys:"
        if missing:
            text += f" missing {', '.join(missing)};"
        if extra:
            text += f" unexpected {', '.join(extra)};"
        return text.rstrip(";")

    def _error(self, kind: str, message: str) -> HostError:
        function = self._component.execute
        code = getattr(function, "__wrapped__", function).__code__
        line = linecache.getline(code.co_filename, code.co_firstlineno)
        column = len(line) - len(line.lstrip()) + 1
        return HostError(f"component.result.{kind}", message, code.co_filename, code.co_firstlineno, column)


def check_component(node: Any, name: str, outputs: list[str] | None) -> None:
    """Put the checks around the component of a node: its attribute `component`, or one with the node's name."""
    for attribute in ("component", name):
        component = getattr(node, attribute, None)
        if isinstance(getattr(component, "execute", None), MethodType):
            setattr(node, attribute, CheckedComponent(component, outputs))
            return


def _problem(value: Any) -> str:
    """What is wrong with a value; infinity is a number of sequences only (REP 117: nothing in range)."""
    if value is None:
        return "None"
    try:
        return "" if isfinite(value) else repr(value)
    except OverflowError:  # an int beyond the range of float
        return ""
    except TypeError:
        return "a sequence with NaN" if _has_nan(value) else ""


def _has_nan(values: Any) -> bool:
    """Whether a sequence of numbers has a NaN in it; quick, because sums keep NaN."""
    if isinstance(values, str | bytes | bytearray | memoryview) or not hasattr(values, "__len__"):
        return False
    if isinstance(values, array) and values.typecode not in "fd":
        return False
    try:
        total = sum(values)
        return bool(total != total and any(value != value for value in values))
    except (TypeError, ValueError):  # not of numbers
        return False
