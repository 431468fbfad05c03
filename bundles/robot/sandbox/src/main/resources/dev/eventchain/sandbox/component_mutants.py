"""List the mutants of a component: small defects, each in one place of its source. Nothing of it is run.

Standard input is a JSON object: ``source``, ``class``, ``swaps`` (pairs of parameters of `execute` of the same type
and unit, and whether they are Booleans), ``outputs`` (each a name, and whether it is a single value), ``node`` (true
for a node that is hosted as it is: mutants are made of what it reaches, and not of what creates its endpoints) and
``importers`` (for a module, the texts of the files that may import it: mutants are made of what they name). Standard
output is a JSON object: ``mutants``, each with ``operator``, ``function``, ``line`` and ``column`` (both from 1, the
column in characters), ``before``, ``after`` and ``edits`` (start, end and new text, in bytes of the source in UTF-8),
or ``problem`` if the source cannot be parsed.
"""

from __future__ import annotations

import ast
import copy
import json
import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

import mutation_operators
import mutation_symmetry
import node_rules
from mutation_operators import Change

_LOGGING = {"print", "debug", "info", "warning", "warn", "error", "critical", "exception", "log"}
"""Functions and methods whose arguments only tell something."""

_PLUMBING = {
    *("create_publisher", "create_subscription", "create_client", "create_service", "create_timer", "create_rate"),
    *("Publisher", "Subscriber", "TimeSynchronizer", "ApproximateTimeSynchronizer", "ActionClient", "ActionServer"),
    *("QoSProfile", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"),
}
"""Functions and classes of ROS 2 that create the endpoints and timers of a node, which its model describes."""


class Mutant(NamedTuple):
    """A defect; see the module for its fields."""

    operator: str
    function: str
    line: int
    column: int
    before: str
    after: str
    edits: list[tuple[int, int, str]]


class Source:
    """A component's text with the places of its nodes."""

    def __init__(self, text: str) -> None:
        self.bytes = text.encode()
        self.tree = ast.parse(text)
        self._starts = [0]
        for line in self.bytes.splitlines(keepends=True):
            self._starts.append(self._starts[-1] + len(line))

    def span(self, node: Any) -> tuple[int, int]:
        """Return where a node starts and ends, in bytes."""
        start = self._starts[node.lineno - 1] + node.col_offset
        return start, self._starts[node.end_lineno - 1] + node.end_col_offset

    def place(self, node: Any) -> tuple[int, int]:
        """Return line and column of a node."""
        start = self._starts[node.lineno - 1]
        return node.lineno, len(self.bytes[start : start + node.col_offset].decode()) + 1

    def indent(self, node: Any) -> str | None:
        """Return the white space before a statement; None if it does not begin its line."""
        start = self._starts[node.lineno - 1]
        before = self.bytes[start : start + node.col_offset].decode()
        return before if not before.strip() else None

    def with_edits(self, edits: list[tuple[int, int, str]]) -> str:
        """Return the text after edits."""
        changed = self.bytes
        for start, end, text in sorted(edits, reverse=True):
            changed = changed[:start] + text.encode() + changed[end:]
        return changed.decode()


class Lister:
    """Lists the mutants of a source."""

    def __init__(self, request: dict[str, Any]) -> None:
        self._source = Source(request["source"])
        self._class: str = request["class"]
        self._swaps: list[tuple[str, str]] = [(first, second) for first, second, _ in request["swaps"]]
        self._booleans = {name for *pair, boolean in request["swaps"] if boolean for name in pair}
        self._outputs: list[tuple[str, bool]] = [(name, single) for name, single in request["outputs"]]
        self._original = ast.dump(self._source.tree)
        self._reached: set[str] | None = None
        if "importers" in request:
            self._reached = node_rules.reached(self._source.tree, node_rules.named(request["importers"]))
        elif request.get("node", False):
            self._reached = node_rules.reached(self._source.tree, {self._class})

    def mutants(self) -> list[Mutant]:
        """Return the mutants in the order of their places; each differs from the source and from the others."""
        found: dict[str, Mutant] = {}
        for mutant in self._visit(self._source.tree, [], None):
            try:
                dump = ast.dump(ast.parse(self._source.with_edits(mutant.edits)))
            except SyntaxError:
                continue
            if dump != self._original:
                found.setdefault(dump, mutant)
        return sorted(found.values(), key=lambda mutant: (mutant.line, mutant.column))

    def _visit(self, node: ast.AST, names: list[str], parent: ast.AST | None) -> Iterator[Mutant]:
        """Yield the mutants of a node and of all that is in it."""
        if _is_left_out(node):
            return
        if self._is_left_out_of_node(node, names):
            if isinstance(node, ast.Call):
                # A callback that is written where it is registered belongs to the node's own work.
                for inside in ast.walk(node):
                    if isinstance(inside, ast.Lambda):
                        yield from self._visit(inside.body, names, inside)
            return
        for change in mutation_operators.of_node(node, parent):
            yield self._replacing(change, names, parent if change.node is node else node)
        inner = names
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            inner = [*names, node.name]
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield from self._of_function(node, inner)
        if isinstance(node, ast.stmt) and names and names[-1] != "__init__":
            yield from self._of_statement(node, names)
        for child in _children(node):
            yield from self._visit(child, inner, node)

    def _is_left_out_of_node(self, node: ast.AST, names: list[str]) -> bool:
        """Return whether a part of a node's file or of a module creates endpoints, or belongs to something else."""
        if self._reached is None:
            return False
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)) and not names:
            return node.name not in self._reached
        return isinstance(node, ast.Call) and _called(node) in _PLUMBING

    def _replacing(self, change: Change, names: list[str], around: ast.AST | None) -> Mutant:
        """Return the mutant that replaces an expression; what is around it makes it recognizable."""
        start, end = self._source.span(change.node)
        text = ast.unparse(change.new)
        if not isinstance(change.new, mutation_operators.ATOMS):
            text = f"({text})"
        before, after = ast.unparse(change.node), ast.unparse(change.new)
        if isinstance(around, ast.Dict):
            key = _key(around, change.node)
            before, after = f"{key}: {before}", f"{key}: {after}"
        elif change.operator in ("constant", "index") and isinstance(around, (ast.expr, ast.Assign, ast.Return)):
            before, after = ast.unparse(around), ast.unparse(_Replacing(change).visit(copy.deepcopy(around)))
        return self._mutant(change.operator, names, change.node, (before, after), [(start, end, text)])

    def _mutant(
        self, operator: str, names: list[str], node: ast.AST, words: tuple[str, str], edits: list[tuple[int, int, str]]
    ) -> Mutant:
        function = ".".join(names[1:] if names[:1] == [self._class] and len(names) > 1 else names)
        return Mutant(operator, function or "module", *self._source.place(node), *words, edits)

    def _of_statement(self, node: ast.stmt, names: list[str]) -> Iterator[Mutant]:
        if mutation_operators.updates_state(node):
            start, end = self._source.span(node)
            yield self._mutant("state", names, node, (ast.unparse(node), "pass"), [(start, end, "pass")])
        if isinstance(node, (ast.For, ast.While)) and not isinstance(node.body[-1], (ast.Break, ast.Return, ast.Raise)):
            indent = self._source.indent(node.body[-1])
            if indent is not None:
                end = self._source.span(node.body[-1])[1]
                words = _first_line(node), "break after the first pass"
                yield self._mutant("return", names, node, words, [(end, end, f"\n{indent}break")])

    def _of_function(self, node: ast.FunctionDef | ast.AsyncFunctionDef, names: list[str]) -> Iterator[Mutant]:
        body = node.body[1:] if ast.get_docstring(node, clean=False) is not None else node.body
        if mutation_operators.returns_nothing(node) and node.name not in ("__init__", "execute"):
            for position, statement in enumerate(body):
                if not all(_only_tells(each) for each in body[position:]):
                    yield from self._inserted("return", names, statement, "return", "return")
        if names == [self._class, "execute"] and body:
            for first, second in self._swaps:
                if not mutation_symmetry.is_symmetric(node, first, second, self._booleans):
                    words = f"{first}, {second} = {second}, {first}"
                    yield from self._inserted("swap", names, body[0], words, words)
            for name, single in self._outputs:
                yield from self._latched(node, names, name, single)

    def _inserted(
        self, operator: str, names: list[str], statement: ast.stmt, text: str, after: str
    ) -> Iterator[Mutant]:
        indent = self._source.indent(statement)
        if indent is not None:
            start = self._source.span(statement)[0]
            words = "before " + _first_line(statement), after
            yield self._mutant(operator, names, statement, words, [(start, start, f"{text}\n{indent}")])

    def _latched(
        self, node: ast.FunctionDef | ast.AsyncFunctionDef, names: list[str], output: str, single: bool
    ) -> Iterator[Mutant]:
        """Let an output keep its first value; a single value, the first one that is neither 0 nor false."""
        returns = [each for each in mutation_operators.own_returns(node) if each.value is not None]
        if not returns or not node.args.args:
            return
        this, key = f"{node.args.args[0].arg}.__dict__", repr(output)
        kept = f"{this}.setdefault('_latched', r[{key}])"
        if single:
            kept = f"({kept} if r[{key}] or '_latched' in {this} else r[{key}])"
        edits = []
        for each in returns:
            start, end = self._source.span(each.value)
            edits += [(start, start, f"(lambda r: {{**r, {key}: {kept}}})("), (end, end, ")")]
        first = "that is not 0" if single else "of all"
        yield self._mutant("latch", names, returns[0], (output, f"the first value {first}, for ever"), edits)


def _key(parent: ast.Dict, value: ast.expr) -> str:
    keys = [key for key, each in zip(parent.keys, parent.values, strict=True) if each is value and key is not None]
    return ast.unparse(keys[0]) if keys else "key"


class _Replacing(ast.NodeTransformer):
    """Replaces the number at one place."""

    def __init__(self, change: Change) -> None:
        self._change = change

    def visit(self, node: ast.AST) -> Any:
        """Return the new node at the place of the change, and all others as they are."""
        old = self._change.node
        same = type(node) is type(old) and isinstance(node, ast.expr) and _start(node) == _start(old)
        return self._change.new if same else self.generic_visit(node)


def _start(node: ast.expr) -> tuple[int, int]:
    return node.lineno, node.col_offset


def _first_line(node: ast.AST) -> str:
    return ast.unparse(node).split("\n", 1)[0]


def _is_left_out(node: ast.AST) -> bool:
    """Return whether a node only tells something, or is never run in a component."""
    if isinstance(node, ast.Call):
        return _called(node) in _LOGGING
    if isinstance(node, ast.If):
        names = {each.id for each in ast.walk(node.test) if isinstance(each, ast.Name)}
        return bool(names & {"__name__", "TYPE_CHECKING"})
    return isinstance(node, (ast.Raise, ast.JoinedStr, ast.Import, ast.ImportFrom))


def _called(node: ast.Call) -> str:
    """Return the last part of the name of what is called."""
    name: str = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
    return name


def _only_tells(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and _called(node.value) in _LOGGING


def _children(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the parts of a node that have an effect: neither annotations nor decorators."""
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "type_params", "msg"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield child


def main() -> None:
    """Answer the request on standard input."""
    request = json.loads(sys.stdin.read())
    try:
        answer: dict[str, Any] = {"mutants": [mutant._asdict() for mutant in Lister(request).mutants()]}
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        answer = {"problem": f"{type(problem).__name__}: {problem}"}
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
