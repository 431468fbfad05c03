"""Reader of the sources of a ROS 2 workspace. None of their code is run, and none is imported.

As a program: standard input is a JSON object with ``packages``, a list with ``name``, and by their paths the texts of
``python`` modules, ``setup`` (setup.py and setup.cfg), ``cpp``, ``cmake`` and ``launch``; each path is that of
questions, and a Python module has its dotted ``module`` name, too. ``again`` is a list of nodes that are also read with
parameters: the number of a ``node``, the ``values`` that it is given, the names of those that are ``unknown``, and
whether there may be others (``open``). Standard output is a JSON object with the ``nodes``, the ``executables`` with
the numbers of their nodes, the ``launch`` files with their elements, the ``questions``, and the nodes read ``again``.
"""

from __future__ import annotations

import ast
import json
import sys
from collections.abc import Iterator
from typing import Any

import cpp_sources
import executables
from constants import Constants, Place
from launch_files import LaunchFile
from made_nodes import Made, NodeClass
from python_nodes import PythonNodes
from ros_parameters import Given
from source_modules import Module, Modules, Question

Json = dict[str, Any]


class Workspace:
    """Content of the sources."""

    def __init__(self, packages: list[Json], again: list[Json]) -> None:
        self._packages = packages
        self._again = again
        self._questions: list[Question] = []
        self._nodes: list[Json] = []
        self._executables: list[Json] = []

    def read(self) -> Json:
        """Return the facts."""
        modules = Modules(self._modules("python"))
        nodes = PythonNodes(modules)
        classes = nodes.classes()
        started = self._python(modules, classes)
        ways: list[tuple[object, ...]] = []
        read: list[Made] = []
        for found in classes:
            made = [each for _, all_made in started for each in all_made if each.node == found]
            for each in made or [Made(found, None, Place(found.module), {})]:
                if each.way not in ways:
                    ways.append(each.way)
                    read.append(each)
                    self._nodes.append(nodes.read(each))
            if not made and not _is_base(found, classes):
                text = f"What starts the node {found.definition.name}? No executable of this workspace does."
                self._questions.append(found.module.question(found.definition, text))
        for executable, all_made in started:
            self._executables.append({**executable, "nodes": [ways.index(each.way) for each in all_made]})
        nodes.ask_for_others(classes)
        self._cpp()
        launch = {
            module.file: LaunchFile(module, Constants(Modules([module]))).read() for module in self._modules("launch")
        }
        return {
            "nodes": self._nodes,
            "executables": self._executables,
            "launch": launch,
            "questions": [each.json for each in [*self._questions, *nodes.questions]],
            "again": [nodes.read(read[each["node"]], _given(each)) for each in self._again],
        }

    def _modules(self, key: str) -> Iterator[Module]:
        for package in self._packages:
            for file, found in package[key].items():
                try:
                    yield Module(file, found["module"], ast.parse(found["text"]))
                except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
                    reason = getattr(problem, "msg", None) or str(problem) or type(problem).__name__
                    line = getattr(problem, "lineno", None) or 1
                    text = f"What does this file do? It is not valid Python: {reason}."
                    self._questions.append(Question(file, line, text))

    def _python(self, modules: Modules, classes: list[NodeClass]) -> list[tuple[Json, list[Made]]]:
        """Return the executables, and the nodes that each makes."""
        started: list[tuple[Json, list[Made]]] = []
        for package in self._packages:
            scripts: list[executables.Executable] = []
            for file, text in package["setup"].items():
                read = executables.of_setup_cfg if file.endswith(".cfg") else executables.of_setup_py
                scripts += read(package["name"], file, text, self._questions)
            for script in scripts:
                made = executables.nodes_of(script, modules, classes, self._questions)
                started.append((_executable(script.package, script.name, script.file, script.line), made))
            for file, text in package["cmake"].items():
                for program in dict.fromkeys(executables.of_cmake(file, text, modules, self._questions)):
                    made = executables.nodes_of_program(program, file, modules, classes, self._questions)
                    started.append((_executable(package["name"], program.name, file, program.line), made))
        return started

    def _cpp(self) -> None:
        for package in self._packages:
            sources = {
                file.rpartition("/")[2]: node
                for file, text in package["cpp"].items()
                if (node := cpp_sources.read(file, text, self._questions)) is not None
            }
            registered = {
                name: (file, sources[file.rpartition("/")[2]])
                for file, text in package["cpp"].items()
                for name in cpp_sources.plugins(text)
                if file.rpartition("/")[2] in sources
            }
            for name, (file, node) in registered.items():
                self._cpp_executable(package["name"], name, file, [node])
            for file, text in package["cmake"].items():
                for name, plugin in cpp_sources.executables_of_plugins(text).items():
                    if plugin in registered:
                        self._cpp_executable(package["name"], name, file, [registered[plugin][1]])
                for name, written in cpp_sources.executables(text).items():
                    found = [
                        node for source, node in sources.items() if source in {w.rpartition("/")[2] for w in written}
                    ]
                    self._cpp_executable(package["name"], name, file, found)

    def _cpp_executable(self, package: str, name: str, file: str, nodes: list[Json]) -> None:
        for node in nodes:
            if node not in self._nodes:
                self._nodes.append(node)
        numbers = [self._nodes.index(node) for node in nodes]
        self._executables.append({**_executable(package, name, file, 1), "nodes": numbers})


def _given(json: Json) -> Given:
    return Given(json["values"], frozenset(json["unknown"]), json["open"])


def _executable(package: str, name: str, file: str, line: int) -> Json:
    return {"package": package, "name": name, "file": file, "line": line}


def _is_base(node: NodeClass, classes: list[NodeClass]) -> bool:
    return any((node.module, node.definition) in each.line[1:] for each in classes)


def main() -> None:
    """Read the request from standard input; write the facts to standard output."""
    sys.setrecursionlimit(3000)
    request = json.load(sys.stdin)
    json.dump(Workspace(request["packages"], request.get("again", [])).read(), sys.stdout)


if __name__ == "__main__":
    main()
