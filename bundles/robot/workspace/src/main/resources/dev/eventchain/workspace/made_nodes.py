"""Nodes of a workspace as its executables make them, and the arguments of their constructors."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import NamedTuple

import node_construction
from constants import Constants, Passed, Place, UnknownValueError, passed
from source_modules import FUNCTIONS, Function, Module

_GIVEN = "'arguments' of its node in components.json say it."

_NODE_NAME = "node_name"  # of rclpy's node

Json = dict[str, object]


class NodeClass(NamedTuple):
    """A class of the workspace that is a node, with its bases in the workspace, nearest first."""

    module: Module
    definition: ast.ClassDef
    line: tuple[tuple[Module, ast.ClassDef], ...]


class Made(NamedTuple):
    """A node as an executable makes it.

    Args:
        call: the call of its class; None if no executable makes it.
        place: the scope of the call.
        passed: what is known of the parameters of functions there.

    """

    node: NodeClass
    call: ast.Call | None
    place: Place
    passed: Passed

    @property
    def way(self) -> tuple[object, ...]:
        """Return what tells it from other ways of making the node."""
        if self.call is None or not (self.call.args or self.call.keywords):
            return (id(self.node.definition),)
        return id(self.node.definition), id(self.place.function), ast.dump(self.call), _given(self.place, self.passed)


def _given(place: Place, passed: Passed) -> tuple[object, ...]:
    """Return what the parameters of a function are given, and those of the functions that call it."""
    if place.function is None:
        return ()
    given = passed.get(place.function, {}).items()
    return tuple(
        (name, id(caller.function), ast.dump(value), _given(caller, passed)) for name, (value, caller) in given
    )


def constructors(node: NodeClass) -> Iterator[tuple[Module, Function]]:
    """Return the constructors of a class and its bases, nearest first."""
    for module, cls in node.line:
        for method in cls.body:
            if isinstance(method, FUNCTIONS) and method.name == "__init__":
                yield module, method
                break


def parameters(made: Made) -> Passed:
    """Return what is known of the parameters where a node is made, and of those of its constructors."""
    known = dict(made.passed)
    call, place = made.call, made.place
    for module, method in constructors(made.node):
        own = Place(module, made.node.line)
        if call is not None:
            known[method] = passed(method, call, place, own)
        call, place = next(constructor_calls(method), None), own._replace(function=method)
    return known


class Arguments:
    """Reads what a constructor is given."""

    def __init__(self, constants: Constants, made: Made, ask: Callable[[Module, ast.AST, str], None]) -> None:
        self._constants = constants
        self._made = made
        self._ask = ask

    def read(self) -> Json | None:
        """Return the arguments of the constructor; None if the file of the class says them when it is hosted."""
        constructor = next(constructors(self._made.node), None)
        call, name = self._made.call, self._made.node.definition.name
        if call is None:
            required = _required(constructor[1]) if constructor is not None else []
            if constructor is not None and required:
                listed = " and ".join(f"'{each}'" for each in required)
                self._ask(*constructor, f"What is {listed} of {name}()? No executable makes one. {_GIVEN}")
            return None
        names = _plain(constructor[1])[1:] if constructor is not None else [_NODE_NAME]
        given = self._given(call, names)
        return None if given == self._own(names) else given

    def _given(self, call: ast.Call, names: list[str]) -> Json | None:
        """Return what a call gives, by the names of parameters; None if a part of it is not known."""
        name = self._made.node.definition.name
        if len(call.args) > len(names) or any(each.arg is None for each in call.keywords):
            self._ask(self._made.place.module, call, f"What are the arguments of {name}()? {_GIVEN}")
            return None
        found: Json = {}
        parts = [*zip(names, call.args, strict=False), *((each.arg or "", each.value) for each in call.keywords)]
        for parameter, value in parts:
            try:
                found[parameter] = self._constants.data(value, self._made.place)
            except UnknownValueError as problem:
                text = f"What is '{parameter}' of {name}(): {problem}? {_GIVEN}"
                self._ask(self._made.place.module, value, text)
        return found if len(found) == len(parts) else None

    def _own(self, names: list[str]) -> Json | None:
        """Return what a host gives if the description says nothing; None if the file of the class does not say it."""
        try:
            own = node_construction.read(self._made.node.module.tree, self._made.node.definition.name)
        except node_construction.UnknownConstructionError:
            return None
        if own is None:
            return {}
        return (
            {**dict(zip(names, own.positional, strict=False)), **own.named}
            if len(own.positional) <= len(names)
            else None
        )


def _required(constructor: Function) -> list[str]:
    """Return the parameters of a constructor that have no default, without the object itself."""
    taken = constructor.args
    plain = _plain(constructor)
    named = [each.arg for each, default in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if default is None]
    return [*plain[1 : len(plain) - len(taken.defaults)], *named]


def _plain(function: Function) -> list[str]:
    return [each.arg for each in (*function.args.posonlyargs, *function.args.args)]


def argument(call: ast.Call, name: str, position: int | None) -> ast.expr | None:
    """Return the argument of a call by its name or position; None if it is not given plainly."""
    for keyword in call.keywords:
        if keyword.arg == name:
            return keyword.value
    if position is None or any(isinstance(each, ast.Starred) for each in call.args[: position + 1]):
        return None
    return call.args[position] if position < len(call.args) else None


def constructor_calls(method: Function) -> Iterator[ast.Call]:
    """Return the calls of ``super().__init__(...)`` and ``Node.__init__(self, ...)``, without ``self``."""
    for node in ast.walk(method):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "__init__":
            arguments = node.args
            if arguments and isinstance(arguments[0], ast.Name) and arguments[0].id == "self":
                arguments = arguments[1:]
            yield ast.Call(func=node.func, args=arguments, keywords=node.keywords)
