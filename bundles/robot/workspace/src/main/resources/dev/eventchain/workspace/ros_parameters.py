"""Parameters of ROS 2: where a class of a node declares them, and what launch gives them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import NamedTuple

from source_modules import FUNCTIONS, Function, Module, last_name

_SETTERS = frozenset({"set_parameters", "set_parameters_atomically", "set_descriptor", "undeclare_parameter"})
_VALUES: dict[str, type] = {
    "value": object,
    "string_value": str,
    "double_value": float,
    "integer_value": int,
    "bool_value": bool,
}
_OPTIONS = frozenset({"parameter_overrides", "cli_args", "use_global_arguments"})


class Given(NamedTuple):
    """Parameters that launch gives a node.

    Args:
        values: by their names.
        unknown: names of those whose values are not known.
        is_open: whether there may be others.

    """

    values: dict[str, object]
    unknown: frozenset[str]
    is_open: bool


class Declaration(NamedTuple):
    """Declaration of a parameter, in a method; without a default, launch has to set it."""

    module: Module
    method: Function
    name: ast.expr
    prefix: ast.expr | None
    default: ast.expr | None
    overrides: bool


def declarations(classes: tuple[tuple[Module, ast.ClassDef], ...]) -> Iterator[Declaration]:
    """Return the declarations of parameters in a class and its bases."""
    for module, cls in classes:
        for method in cls.body:
            if isinstance(method, FUNCTIONS):
                for call in _own_calls(method):
                    for parts in _declared(call):
                        yield Declaration(module, method, *parts)


def sets_parameters(classes: tuple[tuple[Module, ast.ClassDef], ...]) -> bool:
    """Return whether a node changes its parameters itself."""
    calls = (call for _, cls in classes for call in _own_calls(cls))
    return any(isinstance(call.func, ast.Attribute) and call.func.attr in _SETTERS for call in calls)


def options(classes: tuple[tuple[Module, ast.ClassDef], ...]) -> Iterator[tuple[Module, Function, ast.expr]]:
    """Return what constructors give rclpy's node that changes its parameters, or whether launch does."""
    for module, cls in classes:
        for method in cls.body:
            if isinstance(method, FUNCTIONS) and method.name == "__init__":
                for call in ast.walk(method):
                    if isinstance(call, ast.Call) and last_name(call.func) == "__init__":
                        yield from ((module, method, each.value) for each in call.keywords if each.arg in _OPTIONS)


def parameter_of(node: ast.expr) -> ast.expr | None:
    """Return the name of the parameter that a call reads: ``self.get_parameter(NAME).get_parameter_value()``."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr in ("get_parameter", "declare_parameter", "get_parameter_or"):
            return node.args[0] if node.args else _keyword(node, "name")
        if node.func.attr == "get_parameter_value":
            return parameter_of(node.func.value)
    return None


def value_of(node: ast.Attribute) -> ast.expr | None:
    """Return what an expression reads the value of: ``PARAMETER`` of ``PARAMETER.value``."""
    if node.attr not in _VALUES:
        return None
    inner = node.value
    if (
        isinstance(inner, ast.Call)
        and isinstance(inner.func, ast.Attribute)
        and inner.func.attr == "get_parameter_value"
    ):
        return inner.func.value
    return inner


def is_of_type(value: object, member: str) -> bool:
    """Return whether a member of a parameter, such as `double_value`, has its value: others are zero, or empty."""
    return _VALUES.get(member, object) in (object, type(value))


def _own_calls(node: ast.AST) -> Iterator[ast.Call]:
    """Return the calls of methods of ``self`` in a block."""
    for each in ast.walk(node):
        if isinstance(each, ast.Call) and isinstance(each.func, ast.Attribute) and _is_self(each.func.value):
            yield each


def _is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def _keyword(call: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in call.keywords if each.arg == name), None)


def _declared(call: ast.Call) -> Iterator[tuple[ast.expr, ast.expr | None, ast.expr | None, bool]]:
    """Return the name, its prefix, the default, and whether launch may set another one, of each parameter."""
    assert isinstance(call.func, ast.Attribute)
    if call.func.attr == "declare_parameter":
        name = parameter_of(call)
        default = call.args[1] if len(call.args) > 1 else _keyword(call, "value")
        ignores = call.args[3] if len(call.args) > 3 else _keyword(call, "ignore_override")
        overrides = ignores is None or (isinstance(ignores, ast.Constant) and ignores.value is False)
        if name is not None:
            yield name, None, default, overrides
    elif call.func.attr == "declare_parameters" and len(call.args) == 2:
        prefix, listed = call.args
        for each in listed.elts if isinstance(listed, (ast.List, ast.Tuple)) else []:
            if isinstance(each, (ast.List, ast.Tuple)) and each.elts:
                yield each.elts[0], prefix, each.elts[1] if len(each.elts) > 1 else None, len(each.elts) < 4
