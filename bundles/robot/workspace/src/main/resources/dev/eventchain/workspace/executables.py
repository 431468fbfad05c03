"""Executables of Python packages: the console scripts of setup.py and setup.cfg, and the nodes that they make."""

from __future__ import annotations

import ast
import configparser
from typing import NamedTuple

from python_nodes import NodeClass
from source_modules import FUNCTIONS, Function, Module, Modules, Question


class Executable(NamedTuple):
    """An executable of a package: ``name = module:function``."""

    package: str
    name: str
    module: str
    function: str
    file: str
    line: int


def of_setup_py(package: str, file: str, text: str, questions: list[Question]) -> list[Executable]:
    """Return the console scripts in the call of setup()."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        questions.append(Question(file, 1, "Which executables does this package have? This is not valid Python."))
        return []
    found: list[Executable] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found += _entry(package, node.value, file, node.lineno)
    return found


def of_setup_cfg(package: str, file: str, text: str, questions: list[Question]) -> list[Executable]:
    """Return the console scripts in the section ``options.entry_points``."""
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(text)
    except configparser.Error:
        questions.append(Question(file, 1, "Which executables does this package have? This is not readable."))
        return []
    scripts = parser.get("options.entry_points", "console_scripts", fallback="")
    lines = text.splitlines()
    found: list[Executable] = []
    for entry in scripts.splitlines():
        line = next((i for i, each in enumerate(lines, 1) if entry and entry in each), 1)
        found += _entry(package, entry, file, line)
    return found


def _entry(package: str, text: str, file: str, line: int) -> list[Executable]:
    """Return the executable of ``name = module:function``; none if the text is something else."""
    name, equals, target = text.partition("=")
    module, colon, function = target.strip().partition(":")
    parts = [name.strip(), *module.split("."), function.partition("[")[0].strip()]
    plain = all(part.replace("-", "_").replace(".", "_").isidentifier() for part in parts)
    if not equals or not colon or not plain:
        return []
    return [Executable(package, parts[0], module.strip(), parts[-1], file, line)]


def nodes_of(
    executable: Executable, modules: Modules, nodes: list[NodeClass], questions: list[Question]
) -> list[NodeClass]:
    """Return the nodes that the function of an executable makes, in its order."""
    owner = modules.owner(f"{executable.module}.{executable.function}")
    function = owner[0].functions.get(owner[1]) if owner is not None else None
    if owner is None or function is None:
        text = f"What does the executable '{executable.name}' run? {executable.module} has no {executable.function}()."
        questions.append(Question(executable.file, executable.line, text))
        return []
    found = _made(owner[0], function, modules, nodes)
    if not found:
        text = f"Which nodes does the executable '{executable.name}' make? None that is a class of this workspace."
        questions.append(owner[0].question(function, text))
    return found


def _made(module: Module, function: Function, modules: Modules, nodes: list[NodeClass]) -> list[NodeClass]:
    """Return the nodes that a function makes, itself or in functions of its module that it calls."""
    found: list[NodeClass] = []
    pending, seen = [function], {function.name}
    while pending:
        for node in ast.walk(pending.pop(0)):
            if not isinstance(node, ast.Call):
                continue
            named = modules.class_named(module, node.func)
            found += [each for each in nodes if named == (each.module, each.definition) and each not in found]
            inner = module.functions.get(node.func.id) if isinstance(node.func, ast.Name) else None
            if isinstance(inner, FUNCTIONS) and inner.name not in seen:
                seen.add(inner.name)
                pending.append(inner)
    return found
