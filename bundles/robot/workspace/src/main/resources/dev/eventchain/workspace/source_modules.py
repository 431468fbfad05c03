"""Python modules of a workspace as syntax trees: what they import, define and assign. Nothing is executed."""

from __future__ import annotations

import ast
import functools
from collections.abc import Iterable, Iterator
from typing import NamedTuple

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
Function = ast.FunctionDef | ast.AsyncFunctionDef


class Question(NamedTuple):
    """Question that the source leaves open, with its place; one beside topics leaves those of its node known."""

    file: str
    line: int
    text: str
    is_beside_topics: bool = False

    @property
    def json(self) -> dict[str, object]:
        """The question for the caller."""
        json: dict[str, object] = {"file": self.file, "line": self.line, "text": self.text}
        return {**json, "beside_topics": True} if self.is_beside_topics else json


class Binding(NamedTuple):
    """One assignment of a name; without a value where that is not an expression, such as in a loop."""

    value: ast.expr | None
    function: Function | None


class Module:
    """A module.

    Args:
        file: its path, as in questions.
        name: its dotted name; empty for a script.
        tree: its syntax tree.

    """

    def __init__(self, file: str, name: str, tree: ast.Module) -> None:
        self.file = file
        self.name = name
        self.tree = tree
        self.imports: dict[str, str] = {}
        self.unsure: set[str] = set()  # names that stand for one of several imports
        self.stars: list[str] = []
        self.classes = {node.name: node for node in _statements(tree.body) if isinstance(node, ast.ClassDef)}
        self.functions = {node.name: node for node in _statements(tree.body) if isinstance(node, FUNCTIONS)}
        self.names = bindings(tree.body, None)
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    bound = alias.asname or alias.name.partition(".")[0]
                    self._bind(bound, alias.name if alias.asname else bound)
            elif isinstance(node, ast.ImportFrom):
                self._import_from(node)

    @property
    def run(self) -> Iterator[ast.AST]:
        """Return the statements that are run when it is started as a program."""
        return (node for node in self.tree.body if not isinstance(node, (*FUNCTIONS, ast.ClassDef)))

    @property
    def starts(self) -> bool:
        """Return whether it has a part for being started as a program."""
        return any(
            isinstance(node, ast.If)
            and any(isinstance(each, ast.Name) and each.id == "__name__" for each in ast.walk(node.test))
            for node in self.tree.body
        )

    def _import_from(self, node: ast.ImportFrom) -> None:
        above = self.name.split(".")[: -node.level] if node.level else []
        source = ".".join([*above, *([node.module] if node.module else [])])
        for alias in node.names:
            if alias.name == "*":
                self.stars.append(source)
            else:
                self._bind(alias.asname or alias.name, f"{source}.{alias.name}")

    def _bind(self, name: str, full: str) -> None:
        if self.imports.setdefault(name, full) != full:
            self.unsure.add(name)

    def full_name(self, node: ast.expr) -> str | None:
        """Return the dotted name of what an expression names, through the imports: ``std_msgs.msg.String``."""
        if isinstance(node, ast.Attribute):
            owner = self.full_name(node.value)
            return f"{owner}.{node.attr}" if owner else None
        if not isinstance(node, ast.Name):
            return None
        if node.id in self.unsure:
            return None
        if node.id in self.imports:
            return self.imports[node.id]
        if node.id in self.classes:
            return f"{self.name}.{node.id}"
        return f"{self.stars[0]}.{node.id}" if len(self.stars) == 1 and node.id not in self.names else None

    def question(self, node: ast.AST, text: str) -> Question:
        """Return a question about a place in this module."""
        return Question(self.file, getattr(node, "lineno", 1), text)


class Modules:
    """All modules of a workspace by their dotted names."""

    def __init__(self, modules: Iterable[Module]) -> None:
        self.all = list(modules)
        self._named = {module.name: module for module in self.all if module.name}

    def named(self, name: str) -> Module | None:
        """Return the module with a dotted name."""
        return self._named.get(name) or self._named.get(f"{name}.__init__")

    def owner(self, full: str) -> tuple[Module, str] | None:
        """Return the module that defines a dotted name, and the name in it."""
        seen: set[str] = set()
        while full not in seen:
            seen.add(full)
            module_name, _, name = full.rpartition(".")
            module = self.named(module_name)
            if module is None:
                return None
            if name in module.classes or name in module.functions or name in module.names:
                return module, name
            full = module.imports.get(name, full)
        return None

    def class_named(self, module: Module, node: ast.expr) -> tuple[Module, ast.ClassDef] | None:
        """Return the class of the workspace that an expression names."""
        full = module.full_name(node)
        if isinstance(node, ast.Name) and node.id in module.classes:
            return module, module.classes[node.id]
        owner = self.owner(full) if full else None
        if owner is not None and owner[1] in owner[0].classes:
            return owner[0], owner[0].classes[owner[1]]
        return None


def bindings(body: Iterable[ast.AST], function: Function | None) -> dict[str, list[Binding]]:
    """Return what a block assigns to names, with the blocks in it but without functions and classes in it."""
    found: dict[str, list[Binding]] = {}
    for node in _statements(body):
        for target, value in _assigned(node):
            if isinstance(target, ast.Name):
                found.setdefault(target.id, []).append(Binding(value, function))
    return found


@functools.cache
def fields(cls: ast.ClassDef) -> dict[str, list[Binding]]:
    """Return what a class assigns to its attributes, in its body and through ``self`` in its methods."""
    found = bindings(cls.body, None)
    for method in cls.body:
        if not isinstance(method, FUNCTIONS):
            continue
        for node in ast.walk(method):
            for target, value in _assigned(node):
                if is_self_attribute(target):
                    assert isinstance(target, ast.Attribute)
                    found.setdefault(target.attr, []).append(Binding(value, method))
    return found


def last_name(node: ast.expr) -> str:
    """Return the last part of a dotted name; empty if an expression is none."""
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def is_self_attribute(node: ast.AST) -> bool:
    """Return whether a node is ``self.NAME``."""
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self"


def parameters(function: Function) -> set[str]:
    """Return the names of a function's parameters."""
    arguments = function.args
    named = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]
    return {each.arg for each in [*named, arguments.vararg, arguments.kwarg] if each is not None}


def _assigned(node: ast.AST) -> Iterator[tuple[ast.AST, ast.expr | None]]:
    """Return the targets that a statement assigns, and the values of those that are given one by one."""
    if isinstance(node, ast.Assign):
        for target in node.targets:
            yield from _unpacked(target, node.value)
    elif isinstance(node, ast.AnnAssign) and node.value is not None:
        yield node.target, node.value
    elif isinstance(node, (ast.AugAssign, ast.NamedExpr)):
        yield node.target, None
    elif isinstance(node, (ast.For, ast.AsyncFor)):
        yield from _unpacked(node.target, None)
    elif isinstance(node, ast.withitem) and node.optional_vars is not None:
        yield from _unpacked(node.optional_vars, None)


def _unpacked(target: ast.expr, value: ast.expr | None) -> Iterator[tuple[ast.AST, ast.expr | None]]:
    if isinstance(target, (ast.Tuple, ast.List)):
        for element in target.elts:
            yield from _unpacked(element, None)
    else:
        yield target, value


def _statements(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Return the statements of a block and of the blocks in it, except those of functions and classes."""
    for node in body:
        yield node
        if not isinstance(node, (*FUNCTIONS, ast.ClassDef, ast.expr)):
            yield from _statements(ast.iter_child_nodes(node))
