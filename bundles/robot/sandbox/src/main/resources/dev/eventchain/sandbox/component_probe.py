"""Check one component file: parse it, import it, make calls. Runs confined; started by ComponentProbe.

Standard input is a JSON object: ``file``, ``class``, ``inputs``, ``outputs`` and their ``types``, ``calls`` (``name``
and ``arguments``, all made on one component, in order), ``existing`` (true if it is hand-written: it may import and
call what generated ones must not, and import modules next to it), ``sequences`` (lists of such calls, each list made on
a new component object), and for each answer of the component ``processorSeconds`` and ``wallSeconds``. Standard output
is a JSON object: ``findings``, and ``results`` with, for each sequence, the results of its calls (``outputs``) and the
finding that ended it, if any (``problem``). The component runs in a separate process, whose output goes to standard
error: this process runs none of its code.
"""

from __future__ import annotations

import array
import base64
import json
import sys
from pathlib import Path
from typing import Any

import component_results
from component_client import ComponentError, ComponentProcess, ForkServer, Limits
from component_results import Output
from component_rules import STATE_HINT, Component, Finding, check_file
from component_sources import check_needs
from component_values import PLAIN_OBJECTS, Codec, PlainMessage

REPEATED = 50
"""Number of calls that are made again on a second object: what differs differs at once."""


class Probe:
    """Checks of one file."""

    def __init__(self, request: dict[str, Any]) -> None:
        self._file: str = request["file"]
        self._component = Component(request["class"], request["inputs"], request["outputs"])
        self._outputs = [Output(*each) for each in zip(request["outputs"], request["types"], strict=True)]
        self._returned: list[Any] = []
        self._calls: list[dict[str, Any]] = request["calls"]
        self._existing: bool = request["existing"]
        self._sequences: list[list[dict[str, Any]]] = request["sequences"]
        self._limits = Limits(request["processorSeconds"], request["wallSeconds"])
        self._lines = Path(self._file).read_text(encoding="utf-8-sig").split("\n")

    def findings(self) -> list[Finding]:
        """Make all checks; the component is run only if the static checks have no findings."""
        findings = (check_needs if self._existing else check_file)(self._file, self._component)
        return findings or self._try_component()

    def _try_component(self) -> list[Finding]:
        name = self._component.class_name
        stage, hint = "Importing the file", ""
        found: list[Finding] = []
        try:
            process = self._process()
            process.load()
            stage = f"{name}()"
            process.make()
            hint = "Handle every value that the inputs can have: zero, negative, empty, infinite."
            for call in self._calls:
                stage = f"execute() in the call '{call['name']}'"
                found += self._call(process, call)
            if not found:
                stage = f"a second {name}()"
                found += self._check_state(process)
            process.close()
        except ComponentError as problem:
            found.append(self._finding(problem, stage, hint))
        return found

    def results(self) -> list[dict[str, Any]]:
        """Make the calls of each sequence on a new component object."""
        results: list[dict[str, Any]] = []
        process: ComponentProcess | None = None
        for calls in self._sequences:
            outputs: list[Any] = []
            result: dict[str, Any] = {"outputs": outputs}
            stage = f"{self._component.class_name}()"
            try:
                if process is None:
                    process = self._process()
                    process.load()
                process.make()
                for call in calls:
                    stage = f"execute() in the call '{call['name']}'"
                    found = self._call(process, call, outputs)
                    if found:
                        result["problem"] = found[0]._asdict()
                        break
            except ComponentError as problem:
                process = None  # the process has ended
                result["problem"] = self._finding(problem, stage, "")._asdict()
            results.append(result)
        if process is not None:
            process.close()
        return results

    def _process(self) -> ComponentProcess:
        description = {
            "file": self._file,
            "module": "component",
            "class": self._component.class_name,
            "path": [str(Path(self._file).parent)] if self._existing else [],
            "sources": [self._file],
            "plain": True,
        }
        return ComponentProcess(ForkServer.inherited(), description, self._limits, PLAIN_OBJECTS)

    def _call(
        self, process: ComponentProcess, call: dict[str, Any], returned: list[Any] | None = None
    ) -> list[Finding]:
        arguments = {key: decode(value) for key, value in call["arguments"].items()}
        result = process.call((), arguments)
        if len(self._returned) < REPEATED:
            self._returned.append(result.values)
        problems = component_results.check(result.values, self._outputs)
        if returned is not None and not problems:
            returned.append({name: plain(result.values[name]) for name in self._component.outputs})
        return [
            Finding(rule, result.line, result.column, f"In the call '{call['name']}' execute() {message}.", hint)
            for rule, message, hint in problems
        ]

    def _check_state(self, process: ComponentProcess) -> list[Finding]:
        """Check for state outside the object, which would be visible in a second object."""
        process.make()
        codec = Codec(PLAIN_OBJECTS)
        for call, first in zip(self._calls, self._returned, strict=False):
            arguments = {key: decode(value) for key, value in call["arguments"].items()}
            second = process.call((), arguments)
            if codec.write(second.values) != codec.write(first):
                message = f"In the call '{call['name']}' a second object returns something else than the first one did."
                return [Finding("component.state.shared", second.line, second.column, message, STATE_HINT)]
        return []

    def _finding(self, problem: ComponentError, stage: str, hint: str) -> Finding:
        line = max(1, problem.line)
        text = self._lines[line - 1] if line <= len(self._lines) else ""
        column = len(text) - len(text.lstrip()) + 1
        if problem.identifier == "component.raised":
            message = f"{stage} raised {problem}".rstrip(": .") + "."
            if str(problem).startswith("SystemExit"):
                hint = "A component must not end the process."
            elif str(problem).startswith("MemoryError"):
                hint = "Keep less in memory."
            return Finding(problem.identifier, line, column, message, hint)
        if problem.identifier.startswith("component.result."):
            where = stage.removeprefix("execute() in the call ")
            hint = problem.hint or component_results.keys_hint(self._outputs)
            return Finding(problem.identifier, line, problem.column, f"In the call {where} {problem}.", hint)
        return Finding(problem.identifier, line, column, f"{stage}: {problem}.", problem.hint)


def decode(value: Any) -> Any:
    """Convert an argument of a call to the value of a ROS message field."""
    if isinstance(value, dict) and "$bytes" in value:
        return array.array("B", base64.b64decode(value["$bytes"]))
    if isinstance(value, dict) and "$array" in value:
        return array.array(value["$array"], value["values"])
    if isinstance(value, dict) and "$message" in value:
        return PlainMessage(value["$message"], {key: decode(field) for key, field in value["fields"].items()})
    return [decode(item) for item in value] if isinstance(value, list) else value


def plain(value: Any) -> Any:
    """Convert an output to JSON values; bytes become numbers."""
    if isinstance(value, (bytes, bytearray)):
        return list(value)
    return value.tolist() if hasattr(value, "tolist") else value


if __name__ == "__main__":
    probe = Probe(json.loads(sys.stdin.read()))
    findings = probe.findings()
    results = [] if findings else probe.results()
    print(json.dumps({"findings": [finding._asdict() for finding in findings], "results": results}, default=repr))
