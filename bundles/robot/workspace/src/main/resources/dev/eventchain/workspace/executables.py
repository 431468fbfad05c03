"""Executables in Python, and the nodes that they make: console scripts of setup.py and setup.cfg, programs of CMake."""

from __future__ import annotations

import ast
import configparser
import itertools
import re
from collections.abc import Iterator
from typing import NamedTuple

from constants import Passed, Place, passed
from made_nodes import Made, NodeClass
from source_modules import FUNCTIONS, Module, Modules, Question


class Executable(NamedTuple):
    """An executable of a package: ``name = module:function``."""

    package: str
    name: str
    module: str
    function: str
    file: str
    line: int


class Program(NamedTuple):
    """A Python file that a CMakeLists.txt installs under a name; the path is that of the workspace."""

    name: str
    path: str
    line: int


_COMMAND = re.compile(r"\b(set|project|install)\s*\(([^)]*)\)", re.IGNORECASE)
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_KEYWORD = re.compile(r"[A-Z_]+")


def of_cmake(file: str, text: str, modules: Modules, questions: list[Question]) -> Iterator[Program]:
    """Find the Python programs that a CMakeLists.txt installs below `lib`, with variables that it sets itself."""
    plain = re.sub(r"#[^\n]*", "", text)
    folder = file.rpartition("/")[0]
    variables = {each: "." for each in ("CMAKE_CURRENT_SOURCE_DIR", "CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR")}
    variables["CMAKE_INSTALL_LIBDIR"] = "lib"
    for match in _COMMAND.finditer(plain):
        words = _expanded(match[2], variables).replace('"', " ").split()
        command = match[1].lower()
        if command == "project" and words:
            variables["PROJECT_NAME"] = words[0]
        elif command == "set" and words:
            variables[words[0]] = " ".join(words[1:])
        elif command == "install" and "DESTINATION" in words and _option(words, "DESTINATION").startswith("lib"):
            line = plain.count("\n", 0, match.start()) + 1
            yield from _installed(folder, file, line, words, modules, questions)


def _expanded(text: str, variables: dict[str, str]) -> str:
    """Return a text with known variables; those in their values are expanded, too, a few times."""
    for _ in range(4):
        text = _VARIABLE.sub(lambda found: variables.get(found[1], found[0]), text)
    return text


def _option(words: list[str], name: str) -> str:
    return next((value for key, value in itertools.pairwise(words) if key == name), "")


def _installed(
    folder: str, file: str, line: int, words: list[str], modules: Modules, questions: list[Question]
) -> Iterator[Program]:
    for path in itertools.takewhile(lambda each: not _KEYWORD.fullmatch(each), words[1:]):
        if "$" in path and words[0] != "TARGETS":
            text = f"Which programs does this install? '{path}' is not set in this file."
            questions.append(Question(file, line, text))
        elif words[0] == "PROGRAMS" and not path.endswith(".py"):
            text = f"What does the program '{path}' do? By its name it is no Python file, and it is not read."
            questions.append(Question(file, line, text))
        elif words[0] == "PROGRAMS":
            name = _option(words, "RENAME") or path.rpartition("/")[2]
            yield Program(name, _joined(folder, path), line)
        elif words[0] == "DIRECTORY":
            below = _joined(folder, path).rstrip("/") + "/"
            for module in modules.all:
                if module.file.startswith(below) and module.starts:
                    yield Program(module.file.rpartition("/")[2], module.file, line)


def _joined(folder: str, path: str) -> str:
    parts = [part for part in [*folder.split("/"), *path.split("/")] if part not in ("", ".")]
    return "/".join(parts)


def nodes_of_program(
    program: Program, file: str, modules: Modules, nodes: list[NodeClass], questions: list[Question]
) -> list[Made]:
    """Return the nodes that a program makes, in its order."""
    module = next((each for each in modules.all if each.file == program.path), None)
    if module is None:
        text = f"What does the program '{program.name}' run? {program.path} is no Python file that was read."
        questions.append(Question(file, program.line, text))
        return []
    found = _made(module, list(module.run), modules, nodes)
    if not found:
        text = f"Which nodes does the executable '{program.name}' make? None that is a class of this workspace."
        questions.append(Question(module.file, 1, text))
    return found


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


def nodes_of(executable: Executable, modules: Modules, nodes: list[NodeClass], questions: list[Question]) -> list[Made]:
    """Return the nodes that the function of an executable makes, in its order."""
    owner = modules.owner(f"{executable.module}.{executable.function}")
    function = owner[0].functions.get(owner[1]) if owner is not None else None
    if owner is None or function is None:
        lacks = f"{executable.module} has no {executable.function}()"
        if all(module.name != executable.module for module in modules.all):
            lacks = f"No module {executable.module} was read"
        text = f"What does the executable '{executable.name}' run? {lacks}."
        questions.append(Question(executable.file, executable.line, text))
        return []
    found = _made(owner[0], [function], modules, nodes)
    if not found:
        text = f"Which nodes does the executable '{executable.name}' make? None that is a class of this workspace."
        questions.append(owner[0].question(function, text))
    return found


def _made(module: Module, begin: list[ast.AST], modules: Modules, nodes: list[NodeClass]) -> list[Made]:
    """Return the nodes that functions or statements make, themselves or in functions of their module that they call."""
    found: list[Made] = []
    pending: list[tuple[ast.AST, Place]] = []
    known: Passed = {}
    for each in begin:
        function = each if isinstance(each, FUNCTIONS) else None
        pending.append((each, Place(module, (), function)))
        if function is not None:
            known[function] = passed(function, None, Place(module), Place(module))
    while pending:
        part, place = pending.pop(0)
        for node in ast.walk(part):
            if not isinstance(node, ast.Call):
                continue
            named = modules.class_named(module, node.func)
            made = [Made(each, node, place, known) for each in nodes if named == (each.module, each.definition)]
            found += [each for each in made if all(each.way != other.way for other in found)]
            inner = module.functions.get(node.func.id) if isinstance(node.func, ast.Name) else None
            if isinstance(inner, FUNCTIONS):
                given = passed(inner, node, place, Place(module))
                if inner not in known:
                    pending.append((inner, Place(module, (), inner)))
                    known[inner] = given
                elif known[inner] != given:
                    known[inner] = {}  # called in several ways
    return found
