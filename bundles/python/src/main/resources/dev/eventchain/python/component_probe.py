"""Check one component file: read it, import it, make calls. Runs confined; started by ComponentProbe.

Standard input is a JSON object: ``file``, ``class``, ``inputs``, ``outputs``, ``calls`` (``name`` and ``arguments``,
all made on one component, in order) and ``seconds`` for the import and each call. Standard output has one JSON object a
line: ``{"stage": text}`` before a part begins, ``{"finding": ...}``, and ``{"done": true}`` at the end. When a part
takes too long, a traceback as of ``faulthandler`` ends the output. What the component prints goes to standard error.
"""

from __future__ import annotations

import array
import base64
import faulthandler
import json
import math
import os
import sys
import types
from typing import Any, NoReturn

from component_rules import Component, Finding, Rules

MARKER = "_eventchain_returning"


class Probe:
    """The checks of one file."""

    def __init__(self, request: dict[str, Any]) -> None:
        self._file: str = request["file"]
        self._component = Component(request["class"], request["inputs"], request["outputs"])
        self._calls: list[dict[str, Any]] = request["calls"]
        self._seconds: float = request["seconds"]
        with open(self._file, encoding="utf-8-sig", newline="") as file:  # noqa: PTH123
            self._source = file.read()
        self._rules = Rules(self._source, self._component)
        self._channel = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1)
        os.dup2(2, 1)
        self._returned = 1, 1
        self._calling = False

    def run(self) -> None:
        """Make all checks; those that run the component only when reading it found nothing wrong."""
        findings = self._rules.check()
        for finding in findings:
            self._report(finding)
        if not findings:
            self._try_component()
        self._say({"done": True})

    def _try_component(self) -> None:
        self._begin("importing the file")
        module = types.ModuleType("component")
        module.__file__ = self._file
        module.__dict__[MARKER] = self._returning
        sys.modules["component"] = module
        try:
            exec(compile(self._rules.marked_tree(MARKER), self._file, "exec"), module.__dict__)
        except BaseException as problem:
            self._raised("Importing the file", problem)
            return
        name = self._component.class_name
        self._begin(f"making {name}()")
        try:
            component = getattr(module, name)()
        except BaseException as problem:
            self._raised(f"{name}()", problem)
            return
        for call in self._calls:
            self._call(component, call)
        faulthandler.cancel_dump_traceback_later()

    def _returning(self, line: int, column: int, value: Any) -> Any:
        self._returned = line, column
        return value

    def _call(self, component: Any, call: dict[str, Any]) -> None:
        name = call["name"]
        self._calling = True
        self._begin(f"the call '{name}'")
        arguments = {key: decode(value) for key, value in call["arguments"].items()}
        self._returned = self._rules.execute_place()
        try:
            result = component.execute(**arguments)
        except BaseException as problem:
            self._raised(f"execute() in the call '{name}'", problem)
            return
        for rule, message, hint in self._problems(result):
            self._report(Finding(rule, *self._returned, f"In the call '{name}' {message}", hint))

    def _problems(self, result: Any) -> list[tuple[str, str, str]]:
        outputs = self._component.outputs
        expected = f"Return a dict with exactly these keys: {', '.join(outputs)}."
        if type(result) is not dict:
            message = f"execute() returned {type(result).__name__}, not dict."
            return [("component.result.type", message, expected)]
        missing = [key for key in outputs if key not in result]
        extra = [str(key) for key in result if key not in outputs]
        if missing or extra:
            parts = [f"{word} {', '.join(keys)}" for word, keys in (("without", missing), ("with", extra)) if keys]
            return [("component.result.keys", f"execute() returned a dict {' and '.join(parts)}.", expected)]
        return [finding for key in outputs for finding in check_value(key, result[key])]

    def _raised(self, what: str, problem: BaseException) -> None:
        line = 1
        trace = problem.__traceback__
        while trace is not None:
            if trace.tb_frame.f_code.co_filename == self._file:
                line = trace.tb_lineno
            trace = trace.tb_next
        lines = self._source.split("\n")
        text = lines[line - 1] if line <= len(lines) else ""
        column = len(text) - len(text.lstrip()) + 1
        message = f"{what} raised {type(problem).__name__}: {problem}".rstrip(": ") + "."
        self._report(Finding("component.raised", line, column, message, self._hint(problem)))

    def _hint(self, problem: BaseException) -> str:
        if isinstance(problem, SystemExit):
            return "A component must not end the process."
        if isinstance(problem, MemoryError):
            return "Keep less in memory."
        return "Handle every value that the inputs can have: zero, negative, empty, infinite." if self._calling else ""

    def _begin(self, stage: str) -> None:
        self._say({"stage": stage})
        faulthandler.dump_traceback_later(self._seconds, exit=True, file=self._channel)

    def _report(self, finding: Finding) -> None:
        self._say({"finding": finding._asdict()})

    def _say(self, message: dict[str, Any]) -> None:
        self._channel.write(json.dumps(message) + "\n")
        self._channel.flush()


def decode(value: Any) -> Any:
    """Turn an argument of a call into what a ROS message field gives."""
    if isinstance(value, dict) and "$bytes" in value:
        return array.array("B", base64.b64decode(value["$bytes"]))
    if isinstance(value, dict) and "$array" in value:
        return array.array(value["$array"], value["values"])
    return value


def check_value(key: str, value: Any) -> list[tuple[str, str, str]]:
    """What is wrong with one output; infinity is right in a sequence only, as in a laser scan (REP 117)."""
    if isinstance(value, (bool, int, str, bytes, bytearray)):
        return []
    kind = type(value)
    if kind.__module__ == "numpy" and hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (bool, int)):
        return []
    if isinstance(value, float):
        if math.isfinite(value):
            return []
        hint = "Return a finite number in every case."
        return [("component.result.nan", f"execute() returned {value} for '{key}'.", hint)]
    if isinstance(value, (list, tuple, array.array)):
        return check_elements(key, value)
    hint = "Return a number, a truth value, a string, or a list of these."
    return [("component.result.type", f"execute() returned {kind.__name__} for '{key}'.", hint)]


def check_elements(key: str, values: Any) -> list[tuple[str, str, str]]:
    """What is wrong with the elements of a sequence."""
    for index, element in enumerate(values):
        if isinstance(element, float) and math.isnan(element):
            hint = "Use infinity for 'nothing there', as a laser scan does."
            return [("component.result.nan", f"execute() returned nan in '{key}' at index {index}.", hint)]
        if element is None:
            hint = "Return a number for each element."
            return [("component.result.type", f"execute() returned None in '{key}' at index {index}.", hint)]
    return []


def main() -> NoReturn:
    """Check the component that standard input describes."""
    Probe(json.loads(sys.stdin.read())).run()
    sys.stdout.flush()
    os._exit(0)  # a component cannot keep the process with threads or handlers of its own


if __name__ == "__main__":
    main()
