"""Static rules of nodes that are hosted as they are: clocks, random numbers and threads. None of their code is run.

A use is certain in the class of the node, in what that names of the same file, and in what an import runs. Elsewhere in
the file, and in modules that it imports, it may have nothing to do with the node. What `main` does is left out, since a
host makes the node itself.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import component_repeatability
from component_repeatability import CLOCK, RANDOM, THREAD, Use

_HINTS = {
    CLOCK: "Ask self.get_clock() for the time, which is simulated where time is, and use a timer instead of sleeping.",
    RANDOM: "Give a generator of its own a constant seed: random.Random(7).",
    THREAD: "Use a timer or a callback of a subscription, which are called at simulated times.",
}
_UNCERTAIN = "It may be that the hosted node never comes here. "
_STARTER = "main"

Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
_DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)


class Found(NamedTuple):
    """A use, with words for a node, and whether the node is certain to come there."""

    use: Use
    certain: bool


def uses(tree: ast.Module, class_name: str) -> Iterator[Found]:
    """Find what differs from run to run in the file of a node, or in a module that it imports (no class)."""
    statements = list(_flat(tree.body))
    known = _reached(statements, {class_name})
    for use in component_repeatability.uses(tree):
        owner = next((each for each in statements if _holds(each, use.node)), None)
        named = owner.name if isinstance(owner, _DEFINITIONS) else ""
        if named == _STARTER and named not in known:
            continue
        certain = bool(class_name) and (not named or named in known)
        hint = _HINTS[use.rule] if certain else _UNCERTAIN + _HINTS[use.rule]
        yield Found(use._replace(hint=hint), certain)


def reached(tree: ast.Module, names: set[str] | None) -> set[str]:
    """Return the functions and classes of a file that those of these names, or an import of it, may run; None: all."""
    statements = list(_flat(tree.body))
    return _reached(
        statements, {each.name for each in statements if isinstance(each, _DEFINITIONS)} if names is None else names
    )


def named(sources: Iterable[str]) -> set[str] | None:
    """Return the names in files that may mean something of a module that they import; None: any, by `import *`.

    A file that cannot be parsed names nothing: it cannot import anything either.
    """
    found: set[str] = set()
    for source in sources:
        try:
            tree = ast.parse(source)
        except (SyntaxError, ValueError):
            continue
        for node in ast.walk(tree):
            if isinstance(node, ast.Name):
                found.add(node.id)
            elif isinstance(node, ast.Attribute):
                found.add(node.attr)
            elif isinstance(node, ast.alias):
                if node.name == "*":
                    return None
                found.add(node.name)
    return found


def _flat(body: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
    """Return the statements that an import runs, those of blocks one by one."""
    for statement in body:
        is_guarded = isinstance(statement, ast.If) and component_repeatability.is_guard(statement.test)
        parts = ("orelse",) if is_guarded else ("body", "orelse", "finalbody")
        blocks = [getattr(statement, name, []) for name in parts]
        blocks += [handler.body for handler in getattr(statement, "handlers", [])]
        if isinstance(statement, _DEFINITIONS) or not (any(blocks) or is_guarded):
            yield statement
        else:
            yield from (inner for block in blocks for inner in _flat(block))


def _holds(statement: ast.stmt, node: ast.AST) -> bool:
    line: int = getattr(node, "lineno", 0)
    first: int = min([statement.lineno, *(each.lineno for each in getattr(statement, "decorator_list", []))])
    return first <= line <= (statement.end_lineno or statement.lineno)


def _reached(statements: list[ast.stmt], first: set[str]) -> set[str]:
    """Return the names of the definitions that these names or an import mean, directly or through others."""
    definitions: dict[str, Definition] = {each.name: each for each in statements if isinstance(each, _DEFINITIONS)}
    pending: list[ast.AST] = [each for each in statements if not isinstance(each, _DEFINITIONS)]
    found: set[str] = set()
    names = set(first)
    while names or pending:
        for part in pending:
            names.update(each.id for each in ast.walk(part) if isinstance(each, ast.Name))
        new = (names & definitions.keys()) - found
        found |= new
        pending = [definitions[name] for name in sorted(new)]
        names = set()
    return found
