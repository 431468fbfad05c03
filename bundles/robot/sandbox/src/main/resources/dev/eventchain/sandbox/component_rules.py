"""Static rules of a component file: none of its code is run.

Each finding has the id of its rule page, the place in the file, a message and a hint.
"""

from __future__ import annotations

import ast
import functools
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import component_results
from component_reach import reach
from component_repeatability import is_guard
from component_results import Output

# Built-in functions with constant results for constant arguments.
CONSTANT_MAKERS = frozenset(
    {"abs", "bool", "bytes", "complex", "dict", "float", "frozenset", "int", "len", "list", "max", "min", "pow"}
    | {"range", "round", "set", "sorted", "str", "sum", "tuple", "zip"}
)
STATE_HINT = (
    "Keep what is remembered in fields of self that __init__ sets: not in globals, in attributes of the class or in "
    "defaults of parameters."
)

_KINDS: dict[type[ast.AST], str] = {ast.Tuple: "tuple", ast.List: "list", ast.Set: "set", ast.JoinedStr: "str"}
"""Expressions that are no dict whatever is in them."""


class Finding(NamedTuple):
    """A violated rule; `line` and `column` count from 1, the column in characters."""

    id: str
    line: int
    column: int
    message: str
    hint: str


class Component(NamedTuple):
    """Required definitions of a component file."""

    class_name: str
    inputs: list[str]
    outputs: list[str]


class Rules:
    """Checks one file against the description of its component."""

    def __init__(self, source: str, component: Component) -> None:
        self._lines = source.split("\n")
        self._source = source
        self._component = component
        self._tree = ast.Module(body=[], type_ignores=[])

    def check(self) -> list[Finding]:
        """Return all findings, in the order of the file."""
        try:
            self._tree = ast.parse(self._source)
            reached = list(self._reach())
        except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
            return [self._syntax(problem)]
        found = [*reached, *self._effects(), *self._definition()]
        return sorted(set(found), key=lambda finding: (finding.line, finding.column, finding.id, finding.message))

    def marked_tree(self, marker: str) -> ast.Module:
        """Return the file's tree with each `return value` of execute() as `return marker(line, column, value)`."""
        execute = self._method(self._class(), "execute")
        if execute is not None:
            marks = _ReturnMarks(marker, self._place)
            execute.body = [marks.visit(statement) for statement in execute.body]
        return ast.fix_missing_locations(self._tree)

    def execute_place(self) -> tuple[int, int]:
        """Return the place of execute()."""
        execute = self._method(self._class(), "execute")
        return self._place(execute) if execute is not None else (1, 1)

    def _place(self, node: ast.AST) -> tuple[int, int]:
        line: int = getattr(node, "lineno", 1)
        offset: int = getattr(node, "col_offset", 0)
        if isinstance(node, ast.Attribute) and node.end_lineno is not None and node.end_col_offset is not None:
            line, offset = node.end_lineno, node.end_col_offset - len(node.attr.encode())
        text = self._lines[line - 1] if line <= len(self._lines) else ""
        return line, len(text.encode()[:offset].decode(errors="ignore")) + 1

    def _finding(self, rule: str, node: ast.AST, message: str, hint: str) -> Finding:
        return Finding(rule, *self._place(node), message, hint)

    def _syntax(self, problem: Exception) -> Finding:
        line = max(1, getattr(problem, "lineno", None) or 1)
        column = max(1, getattr(problem, "offset", None) or 1)
        text = getattr(problem, "msg", None) or str(problem) or type(problem).__name__
        hint = "Give the file as plain Python, without text or code fences around it."
        return Finding("component.syntax", line, column, f"This is not valid Python: {text}.", hint)

    def _reach(self) -> Iterator[Finding]:
        for problem in reach(self._tree):
            yield self._finding(*problem)

    def _effects(self) -> Iterator[Finding]:
        for node in self._tree.body:
            problem = self._effect(node)
            if problem is not None:
                message = "Importing the file must only define things; this statement does something."
                hint = "Put it into a method of the class, or into a constant made of constants."
                yield self._finding("component.import.effect", problem, message, hint)
        for shared in [node for node in ast.walk(self._tree) if isinstance(node, ast.Global)]:
            message = f"A component must not change {names(shared.names)} outside of its object."
            yield self._finding("component.state.shared", shared, message, STATE_HINT)
        for cls in [node for node in ast.walk(self._tree) if isinstance(node, ast.ClassDef)]:
            for node in cls.body:
                if isinstance(node, (ast.For, ast.While, ast.With, ast.Try)):
                    message = "A class body must only define things; this statement does something."
                    yield self._finding("component.import.effect", node, message, "Put it into a method of the class.")

    def _effect(self, node: ast.stmt) -> ast.AST | None:
        """Return the part of a top-level statement that has an effect other than a definition."""
        if isinstance(
            node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom, ast.Pass)
        ):
            return None
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return None
        if isinstance(node, (ast.Assign, ast.AnnAssign)):
            return self._not_constant(node.value) if node.value is not None else None
        if isinstance(node, ast.If) and is_guard(node.test):
            return None
        return node

    def _not_constant(self, value: ast.expr) -> ast.AST | None:
        imported = set(_imported_names(self._tree))
        for node in ast.walk(value):
            if isinstance(node, (ast.Await, ast.Yield, ast.YieldFrom, ast.NamedExpr)):
                return node
            if isinstance(node, ast.Call):
                base: ast.expr = node.func
                while isinstance(base, ast.Attribute):
                    base = base.value
                if not isinstance(base, ast.Name) or base.id not in imported | CONSTANT_MAKERS:
                    return node
        return None

    def _class(self) -> ast.ClassDef | None:
        return self._class_named(self._component.class_name)

    def _class_named(self, name: str) -> ast.ClassDef | None:
        found = [node for node in self._tree.body if isinstance(node, ast.ClassDef) and node.name == name]
        return found[-1] if found else None

    def _method(self, cls: ast.ClassDef | None, name: str) -> ast.FunctionDef | ast.AsyncFunctionDef | None:
        """Return the method of a class, or of a base class in the same file."""
        seen: set[str] = set()
        while cls is not None and cls.name not in seen:
            seen.add(cls.name)
            for node in reversed(cls.body):
                if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.name == name:
                    return node
            bases = [base.id for base in cls.bases if isinstance(base, ast.Name)]
            cls = self._class_named(bases[0]) if bases else None
        return None

    def _definition(self) -> Iterator[Finding]:
        name = self._component.class_name
        cls = self._class()
        if cls is None:
            others = [node for node in self._tree.body if isinstance(node, ast.ClassDef)]
            found = f"The file defines {', '.join(other.name for other in others)}." if others else ""
            place = self._place(others[0]) if others else (1, 1)
            message = f"The file does not define the class '{name}'."
            yield Finding("component.class.missing", *place, message, f"Name the class '{name}'. {found}".strip())
            return
        execute = self._method(cls, "execute")
        if execute is None:
            yield self._signature(cls, f"The class '{name}' has no method execute().")
        else:
            yield from self._execute(execute)
        constructor = self._method(cls, "__init__")
        if constructor is not None and required(constructor):
            message = f"{name}() is made without arguments, but __init__ needs {', '.join(required(constructor))}."
            hint = "Give each parameter of __init__ a default, or make it a constant."
            yield self._finding("component.constructor.signature", constructor, message, hint)

    def _execute(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[Finding]:
        inputs = self._component.inputs
        named = [argument.arg for argument in (*node.args.args, *node.args.kwonlyargs)]
        if isinstance(node, ast.AsyncFunctionDef):
            yield self._signature(node, "execute() must not be async.")
        if not _is_static(node) and not (node.args.posonlyargs or node.args.args):
            yield self._signature(node, "execute() is a method: its first parameter has to be self.")
            return
        missing = [name for name in inputs if name not in named]
        if missing:
            yield self._signature(node, f"execute() does not take {names(missing)}.")
        first = [argument.arg for argument in (*node.args.posonlyargs, *node.args.args)][:1]
        if not _is_static(node) and first[0] in inputs:
            yield self._signature(node, f"execute() is a method: its first parameter is self, not '{first[0]}'.")
        extra = [name for name in required(node) if name not in inputs]
        if extra:
            yield self._signature(node, f"execute() takes {names(extra)}, which nobody gives it.")
        for returned in returns(node):
            yield from self._result(returned)

    def _result(self, node: ast.Return) -> Iterator[Finding]:
        """Check the result of a `return` as far as it is constant, even if no trial reaches it."""
        value, outputs = node.value, [Output(name) for name in self._component.outputs]
        if isinstance(value, ast.Dict):
            keys = [key.value for key in value.keys if isinstance(key, ast.Constant)]
            if len(keys) == len(value.keys):
                for rule, message, hint in component_results.check_keys(keys, outputs):
                    yield self._finding(rule, node, f"execute() {message} here.", hint)
        elif value is None or isinstance(value, ast.Constant) or type(value) in _KINDS:
            constant = type(value.value if isinstance(value, ast.Constant) else None).__name__
            kind = constant if value is None or isinstance(value, ast.Constant) else _KINDS[type(value)]
            message = f"execute() returned {kind}, not dict."
            yield self._finding("component.result.type", node, message, component_results.keys_hint(outputs))

    def _signature(self, node: ast.AST, message: str) -> Finding:
        expected = f"def execute({', '.join(['self', *self._component.inputs])}):"
        return self._finding("component.execute.signature", node, message, f"Write it as: {expected}")


def decode(content: bytes) -> str:
    """Return the text of a component file, with its line ends."""
    return content.decode("utf-8-sig")


def check_file(file: str, component: Component) -> list[Finding]:
    """Check one file without running its code."""
    return list(_checked(Path(file).read_bytes(), component.class_name, *map(tuple, component[1:])))


@functools.lru_cache
def _checked(content: bytes, class_name: str, inputs: tuple[str, ...], outputs: tuple[str, ...]) -> tuple[Finding, ...]:
    """Check the content of a file; scenario after scenario has the same files."""
    return tuple(Rules(decode(content), Component(class_name, list(inputs), list(outputs))).check())


class _ReturnMarks(ast.NodeTransformer):
    """Marks the return statements of one function, except in functions inside it."""

    def __init__(self, marker: str, place: Callable[[ast.AST], tuple[int, int]]) -> None:
        self._marker = marker
        self._place = place

    def visit_Return(self, node: ast.Return) -> ast.Return:
        place = [ast.Constant(number) for number in self._place(node)]
        value = node.value or ast.Constant(None)
        node.value = ast.copy_location(ast.Call(ast.Name(self._marker, ast.Load()), [*place, value], []), value)
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        return node


def names(each: Iterable[str]) -> str:
    """Return names for a sentence."""
    return ", ".join(f"'{name}'" for name in each)


def _is_static(node: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return any(isinstance(mark, ast.Name) and mark.id == "staticmethod" for mark in node.decorator_list)


def required(node: ast.FunctionDef | ast.AsyncFunctionDef) -> list[str]:
    """Return the parameters that a call has to give, without self."""
    positional = [argument.arg for argument in (*node.args.posonlyargs, *node.args.args)]
    needed = positional[: len(positional) - len(node.args.defaults)]
    if not _is_static(node):
        needed = needed[1:] if positional[:1] == needed[:1] else needed
    keyword = zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True)
    return [*needed, *(argument.arg for argument, default in keyword if default is None)]


def returns(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.Return]:
    """Return the return statements of a function, except in functions inside it."""
    pending: list[ast.AST] = list(function.body)
    while pending:
        node = pending.pop(0)
        if isinstance(node, ast.Return):
            yield node
        elif not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            pending += ast.iter_child_nodes(node)


def _imported_names(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for name in node.names:
                yield (name.asname or name.name).partition(".")[0]
