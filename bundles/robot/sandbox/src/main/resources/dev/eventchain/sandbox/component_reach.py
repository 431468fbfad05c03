"""Accesses of a component file to its outside: modules, built-in names, and attributes that lead out of it.

Found in the syntax tree, without running the file. A module must not be used as a value, only for its names in
:data:`component_names.ALLOWED_NAMES`.
"""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from component_names import (
    ALLOWED_NAMES,
    CLOCK_NAMES,
    FILE_NAMES,
    RANDOM_NAMES,
    REACHING_ATTRIBUTES,
    SPECIAL_METHODS,
)

PACKAGES = frozenset(module.partition(".")[0] for module in ALLOWED_NAMES)
MIDDLEWARE = frozenset(
    {"ackermann_msgs", "ament_index_python", "carla", "cyclonedds", "fastdds", "launch", "message_filters", "rclpy"}
    | {"rosidl_runtime_py", "rospy", "tf2_ros", "tf2_py", "zenoh"}
)
CLOCKS = frozenset({"asyncio", "datetime", "sched", "threading", "time", "timeit"})
RANDOMNESS = frozenset({"random", "secrets", "uuid"})
FORBIDDEN_NAMES = frozenset(
    {
        *("breakpoint", "compile", "copyright", "credits", "delattr", "eval", "exec", "exit", "getattr", "globals"),
        *("help", "id", "input", "license", "locals", "memoryview", "open", "quit", "setattr", "type", "vars"),
    }
)
SPECIAL_NAMES = frozenset({"__class__", "__debug__", "__doc__", "__module__", "__name__", "__qualname__"})
SPECIAL_CONSTANTS = frozenset({"__all__", "__author__", "__doc__", "__slots__", "__version__"})
SPECIAL_ATTRIBUTES = SPECIAL_METHODS | {"__class__", "__name__", "__doc__"}
ENUMERATIONS = frozenset({"Enum", "Flag", "IntEnum", "IntFlag", "StrEnum"})
CLOCK_TYPE = re.compile(r"[<>=|]?(datetime64|M8)(\[.*\])?")

IMPORT, CALL = "component.import.forbidden", "component.call.forbidden"
REPEATABLE = "The same inputs have to give the same outputs."
SIMULATED = "A component runs in simulated time too: it counts its own calls, which come at the node's frequency."
ITSELF = "A component computes its outputs from its inputs and its own fields; it needs nothing else."

Comprehension = ast.ListComp | ast.SetComp | ast.DictComp | ast.GeneratorExp
Function = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


class Problem(NamedTuple):
    """A rule that a node breaks."""

    rule: str
    node: ast.AST
    message: str
    hint: str


class _Scope(NamedTuple):
    """The names of a function, a lambda or a comprehension."""

    own: set[str]
    imported: set[str]
    outer: set[str]


def reach(tree: ast.Module) -> list[Problem]:
    """Find all forbidden accesses of a file, in no particular order."""
    return _Reader(tree).found


class _Reader(ast.NodeVisitor):
    """Visitor of one file."""

    def __init__(self, tree: ast.Module) -> None:
        self.found: list[Problem] = []
        self._scopes: list[_Scope] = []
        self._excused: set[ast.AST] = set()
        self._modules: dict[str, set[str]] = {}
        self._enumerations: set[str] = set()
        for node in ast.walk(tree):
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                self._bind(node)
            elif isinstance(node, ast.ClassDef) and any(self._is_enumeration(base) for base in node.bases):
                self._enumerations.add(node.name)
        self.visit(tree)

    def _bind(self, node: ast.Import | ast.ImportFrom) -> None:
        """Collect the names bound to modules by any import."""
        for alias in node.names:
            if isinstance(node, ast.Import):
                module = alias.name if alias.asname else alias.name.partition(".")[0]
                name = alias.asname or module
            else:
                module = f"{node.module}.{alias.name}"
                name = alias.asname or alias.name
                if node.module == "enum" and alias.name in ENUMERATIONS:
                    self._enumerations.add(name)
            if module in ALLOWED_NAMES:
                self._modules.setdefault(name, set()).add(module)

    # Imports

    def visit_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            if alias.name not in ALLOWED_NAMES:
                self._forbidden_import(node, alias.name)

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        module = "." * node.level + (node.module or "")
        if module not in ALLOWED_NAMES:
            self._forbidden_import(node, module)
            return
        for alias in node.names:
            if alias.name == "*":
                message = f"A component must not import everything from '{module}'."
                self._add(IMPORT, node, message, "Import the names that it needs, or the module itself.")
            else:
                self._take(alias, {module}, alias.name)

    def _forbidden_import(self, node: ast.stmt, module: str) -> None:
        self._add(IMPORT, node, f"A component must not import '{module}'.", _import_hint(module))

    def _take(self, node: ast.AST, modules: Iterable[str], name: str) -> None:
        for module in sorted(modules):
            if f"{module}.{name}" not in ALLOWED_NAMES and name not in ALLOWED_NAMES[module]:
                self._add(IMPORT, node, f"A component must not use '{module}.{name}'.", _name_hint(module, name))

    # Scopes

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        for statement in node.body:
            if isinstance(statement, (ast.Import, ast.ImportFrom)):
                message = "A class body must not import: what it imports would be an attribute of the class."
                self._add(IMPORT, statement, message, "Import at the top of the file.")
        self.generic_visit(node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self._special(node, node.name, SPECIAL_METHODS)
        self._function(node, node.body)

    def visit_AsyncFunctionDef(self, node: ast.AsyncFunctionDef) -> None:
        self._special(node, node.name, SPECIAL_METHODS)
        self._function(node, node.body)

    def visit_Lambda(self, node: ast.Lambda) -> None:
        self._function(node, [node.body])

    def _function(self, node: Function, body: list[ast.stmt] | list[ast.expr]) -> None:
        inside = set(body)
        for child in ast.iter_child_nodes(node):
            if child not in inside:
                self.visit(child)
        arguments = {argument.arg for argument in ast.walk(node.args) if isinstance(argument, ast.arg)}
        self._scopes.append(_scope(arguments, body))
        for part in body:
            self.visit(part)
        self._scopes.pop()

    def visit_ListComp(self, node: ast.ListComp) -> None:
        self._comprehension(node)

    def visit_SetComp(self, node: ast.SetComp) -> None:
        self._comprehension(node)

    def visit_DictComp(self, node: ast.DictComp) -> None:
        self._comprehension(node)

    def visit_GeneratorExp(self, node: ast.GeneratorExp) -> None:
        self._comprehension(node)

    def _comprehension(self, node: Comprehension) -> None:
        """Visit a comprehension; its first iterable belongs to the enclosing scope."""
        first = node.generators[0]
        self.visit(first.iter)
        targets = {name.id for part in node.generators for name in ast.walk(part.target) if isinstance(name, ast.Name)}
        self._scopes.append(_Scope(targets, set(), set()))
        for part in node.generators:
            self.visit(part.target)
            if part is not first:
                self.visit(part.iter)
            for condition in part.ifs:
                self.visit(condition)
        for value in (node.key, node.value) if isinstance(node, ast.DictComp) else (node.elt,):
            self.visit(value)
        self._scopes.pop()

    def _is_own(self, name: str) -> bool:
        """Return whether an enclosing function binds the name; a binding in the module may be late or be deleted."""
        for scope in reversed(self._scopes):
            if name in scope.outer or name in scope.imported:
                return False
            if name in scope.own:
                return True
        return False

    def _modules_of(self, node: ast.expr) -> set[str]:
        """Return the modules that an expression may refer to; empty if it is not a module."""
        if isinstance(node, ast.Name):
            return set() if self._is_own(node.id) else self._modules.get(node.id, set())
        if isinstance(node, ast.Attribute):
            modules = {f"{module}.{node.attr}" for module in self._modules_of(node.value)}
            return {module for module in modules if module in ALLOWED_NAMES}
        return set()

    # Names and attributes

    def visit_Name(self, node: ast.Name) -> None:
        if not isinstance(node.ctx, ast.Load):
            self._special(node, node.id, SPECIAL_CONSTANTS | SPECIAL_METHODS)
        elif node in self._excused or self._is_own(node.id):
            return
        elif self._modules_of(node):
            self._module_as_value(node)
        elif node.id in FORBIDDEN_NAMES:
            self._forbidden(node, node.id)
        else:
            self._special(node, node.id, SPECIAL_NAMES)

    def visit_Attribute(self, node: ast.Attribute) -> None:
        modules = self._modules_of(node.value)
        if not modules:
            if node not in self._excused:
                self._attribute(node, node.attr, not isinstance(node.ctx, ast.Load))
            self.visit(node.value)
            return
        self._take(node, modules, node.attr)
        if not isinstance(node.ctx, ast.Load):
            self._add(CALL, node, f"A component must not change '{ast.unparse(node)}'.", ITSELF)
        elif self._modules_of(node) and node not in self._excused:
            self._module_as_value(node)
        if isinstance(node.value, ast.Attribute):
            self._excused.add(node.value)
            self.visit(node.value)

    def visit_MatchClass(self, node: ast.MatchClass) -> None:
        for name in node.kwd_attrs:
            self._attribute(node, name, False)
        self.generic_visit(node)

    def _attribute(self, node: ast.AST, name: str, changed: bool) -> None:
        if name in REACHING_ATTRIBUTES:
            self._forbidden(node, name)
        elif name in ("format", "format_map"):
            message = f"A component must not use '{name}' with fields that are computed or reach attributes."
            self._add(CALL, node, message, 'Write an f-string, or format a constant: "{:.2f}".format(x).')
        else:
            self._special(node, name, frozenset() if changed else SPECIAL_ATTRIBUTES)

    def _special(self, node: ast.AST, name: str, harmless: frozenset[str]) -> None:
        if name.startswith("__") and name.endswith("__") and name not in harmless:
            self._forbidden(node, name)

    def _module_as_value(self, node: ast.expr) -> None:
        name = ast.unparse(node)
        message = f"A component must not use the module '{name}' as a value."
        self._add(IMPORT, node, message, f"Take a name from it where it is needed: {name}.NAME.")

    # Calls

    def visit_Call(self, node: ast.Call) -> None:
        called, arguments = node.func, node.args
        plain = not node.keywords and not any(isinstance(argument, ast.Starred) for argument in arguments)
        if isinstance(called, ast.Name):
            if called.id == "getattr" and plain and len(arguments) in (2, 3):
                self._constant_getattr(called, arguments[1])
            elif called.id == "type" and plain and len(arguments) == 1:
                self._excused.add(called)
            elif called.id in ("isinstance", "issubclass"):
                self._excused.update(a for a in arguments if isinstance(a, ast.Name) and a.id == "type")
        elif isinstance(called, ast.Attribute) and called.attr == "format" and isinstance(called.value, ast.Constant):
            self._constant_format(called, called.value.value)
        if self._is_enumeration(called) and not (plain and len(arguments) == 1):
            message = "A component must not make an enumeration by a call: its names would be computed."
            self._add(CALL, node, message, "Write it as a class with a line for each name.")
        self.generic_visit(node)

    def visit_Subscript(self, node: ast.Subscript) -> None:
        if isinstance(node.value, ast.Name) and node.value.id == "type":
            self._excused.add(node.value)  # a type annotation
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, str) and CLOCK_TYPE.fullmatch(node.value):
            self._add(CALL, node, f"A component must not use '{node.value}', which can be the current time.", SIMULATED)

    def _constant_getattr(self, called: ast.Name, wanted: ast.expr) -> None:
        """getattr(x, "plain_name") is equivalent to x.plain_name; any other use can reach every attribute."""
        if isinstance(wanted, ast.Constant) and isinstance(wanted.value, str):
            self._excused.add(called)
            self._attribute(wanted, wanted.value, False)

    def _constant_format(self, called: ast.Attribute, text: object) -> None:
        if isinstance(text, str) and not any(re.search(r"[.\[]", field) for field in _fields(text)):
            self._excused.add(called)

    def _is_enumeration(self, node: ast.expr) -> bool:
        if isinstance(node, ast.Attribute):
            return node.attr in ENUMERATIONS and "enum" in self._modules_of(node.value)
        return isinstance(node, ast.Name) and node.id in self._enumerations

    def _forbidden(self, node: ast.AST, name: str) -> None:
        self._add(CALL, node, f"A component must not use '{name}'.", ITSELF)

    def _add(self, rule: str, node: ast.AST, message: str, hint: str) -> None:
        self.found.append(Problem(rule, node, message, hint))


def _fields(text: str) -> Iterator[str]:
    """Return the fields of a format, also in its specifications; a forbidden one if the format is invalid."""
    try:
        for _, field, specification, _ in string.Formatter().parse(text):
            yield field or ""
            yield from _fields(specification or "")
    except ValueError:
        yield "."


def _scope(arguments: set[str], body: Iterable[ast.AST]) -> _Scope:
    """Return the names bound by a function, without those of functions, classes and comprehensions inside it."""
    scope = _Scope(set(arguments), set(), set())
    pending = list(body)
    while pending:
        node = pending.pop()
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            scope.own.add(node.name)
            pending += node.decorator_list  # places of possible assignment expressions
            continue
        if isinstance(node, ast.Lambda):
            continue
        if isinstance(node, (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)):
            scope.own.update(n.target.id for n in ast.walk(node) if isinstance(n, ast.NamedExpr))
            continue
        _note(node, scope)
        pending += ast.iter_child_nodes(node)
    scope.own.difference_update(scope.outer)
    return scope


def _note(node: ast.AST, scope: _Scope) -> None:
    if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
        scope.own.add(node.id)
    elif isinstance(node, (ast.ExceptHandler, ast.MatchAs, ast.MatchStar)) and node.name:
        scope.own.add(node.name)
    elif isinstance(node, ast.MatchMapping) and node.rest:
        scope.own.add(node.rest)
    elif isinstance(node, (ast.Import, ast.ImportFrom)):
        scope.imported.update((alias.asname or alias.name).partition(".")[0] for alias in node.names)
    elif isinstance(node, ast.Global):
        scope.outer.update(node.names)


def _import_hint(module: str) -> str:
    package, _, name = module.partition(".")
    if package in MIDDLEWARE or package.endswith(("_msgs", "_srvs", "_interfaces")):
        return (
            "A component does no communication: it gets plain values as arguments of execute() and returns a dict; "
            "the generated node around it does the rest."
        )
    if package in CLOCKS:
        return SIMULATED
    if package in RANDOMNESS:
        return REPEATABLE
    if not package:
        return "A component is one file."
    if package in PACKAGES:
        return _name_hint(package, name)
    return f"Allowed are {', '.join(sorted(PACKAGES - {'__future__'}))}."


def _name_hint(module: str, name: str) -> str:
    if name in RANDOM_NAMES:
        return REPEATABLE
    if name in CLOCK_NAMES:
        return SIMULATED
    if name in FILE_NAMES:
        return "A component reads and writes no files: what it needs comes as an input, or is a constant."
    return f"Take from '{module}' what computes: a function, class or constant for numbers and collections."
