"""Values of expressions that are known without running anything."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable
from typing import NamedTuple

from ros_parameters import (
    Declaration,
    Given,
    declarations,
    is_of_type,
    options,
    parameter_of,
    sets_parameters,
    value_of,
)
from source_modules import Binding, Function, Module, Modules, bindings, fields, is_self_attribute, parameters

_DEEPEST = 40
_LONGEST = 10_000
_OPERATORS: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
}

Value = str | int | float | bool | None
Data = Value | list["Data"] | dict[str, "Data"]


class UnknownValueError(Exception):
    """A value that the source does not say, with the reason, a clause."""


class Place(NamedTuple):
    """Scope of an expression: what its names mean.

    Args:
        classes: the class of ``self`` and its bases in the workspace, each with its module; empty outside a class.

    """

    module: Module
    classes: tuple[tuple[Module, ast.ClassDef], ...] = ()
    function: Function | None = None


Passed = dict[Function, dict[str, tuple[ast.expr, Place]]]
"""Arguments by the parameters of functions that are called in one way, and where these are written."""


class Constants:
    """Folds expressions in the modules of a workspace.

    Args:
        passed: what is known of parameters of functions.
        given: what launch gives the parameters of the node; nothing by default.

    """

    def __init__(self, modules: Modules, passed: Passed | None = None, given: Given | None = None) -> None:
        self._modules = modules
        self._passed = passed or {}
        self._given = given or Given({}, frozenset(), False)
        self.reads: set[str] = set()
        """The parameters of ROS 2 that were asked for."""

    def of_node(self, passed: Passed, given: Given | None) -> Constants:
        """Return these constants with what is known of parameters."""
        return Constants(self._modules, passed, given)

    def data(self, node: ast.expr, place: Place) -> Data:
        """Return the value of an expression, which may be a list or a dictionary of such values, too."""
        if isinstance(node, ast.List):
            return [self.data(each, place) for each in node.elts]
        if isinstance(node, ast.Dict):
            keys = [self.text(each, place) for each in node.keys if each is not None]
            if len(keys) == len(node.keys):
                return {key: self.data(each, place) for key, each in zip(keys, node.values, strict=True)}
        value = self.value(node, place)
        if isinstance(value, float) and not math.isfinite(value):
            raise UnknownValueError("it is no finite number")
        return value

    def value(self, node: ast.expr, place: Place, depth: int = 0) -> Value:
        """Return the value of an expression; raise UnknownValueError if it is not constant."""
        if depth > _DEEPEST:
            raise UnknownValueError("it leads in a circle")
        if isinstance(node, ast.Constant) and isinstance(node.value, (str, int, float, bool, type(None))):
            return node.value
        if isinstance(node, ast.JoinedStr):
            return "".join(self._part(part, place, depth) for part in node.values)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -_number(self.value(node.operand, place, depth + 1))
        if isinstance(node, ast.BinOp):
            return self._operation(node, place, depth)
        if isinstance(node, ast.Call):
            return self._call(node, place, depth)
        if isinstance(node, (ast.Name, ast.Attribute)):
            inner, there = self.definition(node, place)
            value = self.value(inner, there, depth + 1)
            if isinstance(node, ast.Attribute) and parameter_of(inner) is not None and not is_of_type(value, node.attr):
                raise UnknownValueError(f"it is '{_text(node)}' of a parameter that is {value!r}")
            return value
        raise UnknownValueError(f"it is '{_text(node)}'")

    def text(self, node: ast.expr, place: Place) -> str:
        """Return the value of an expression that has to be a text."""
        value = self.value(node, place)
        if not isinstance(value, str):
            raise UnknownValueError(f"it is {value!r}, which is no text")
        return value

    def number(self, node: ast.expr, place: Place) -> float:
        """Return the value of an expression that has to be a number."""
        return _number(self.value(node, place))

    def definition(self, node: ast.expr, place: Place) -> tuple[ast.expr, Place]:
        """Return the only expression that a name or attribute is given, and where that is."""
        if is_self_attribute(node):
            assert isinstance(node, ast.Attribute)
            return self._field(node.attr, place)
        if isinstance(node, ast.Name):
            return self._name(node.id, place)
        if isinstance(node, ast.Attribute):
            return self._attribute(node, place)
        raise UnknownValueError(f"it is '{_text(node)}'")

    def _part(self, part: ast.expr, place: Place, depth: int) -> str:
        if isinstance(part, ast.FormattedValue):
            if part.conversion != -1 or part.format_spec is not None:
                raise UnknownValueError("it is formatted")
            return str(self.value(part.value, place, depth + 1))
        return str(self.value(part, place, depth + 1))

    def _operation(self, node: ast.BinOp, place: Place, depth: int) -> Value:
        left, right = (self.value(side, place, depth + 1) for side in (node.left, node.right))
        if isinstance(node.op, ast.Add) and isinstance(left, str) and isinstance(right, str):
            if len(left) + len(right) > _LONGEST:
                raise UnknownValueError("it is too long")
            return left + right
        apply = _OPERATORS.get(type(node.op))
        if apply is None:
            raise UnknownValueError(f"it is '{_text(node)}'")
        try:
            return apply(_number(left), _number(right))
        except (ArithmeticError, ValueError) as problem:
            raise UnknownValueError(f"it is '{_text(node)}': {problem}") from problem

    def _call(self, node: ast.Call, place: Place, depth: int) -> Value:
        parameter = parameter_of(node)
        if parameter is not None:
            return self._parameter(parameter, node, place, depth)
        if isinstance(node.func, ast.Name) and len(node.args) == 1 and not node.keywords:
            value = self.value(node.args[0], place, depth + 1)
            if node.func.id == "str":
                return str(value)
            if node.func.id == "float":
                return float(_number(value))
        raise UnknownValueError(f"it is '{_text(node)}'")

    def _parameter(self, written: ast.expr, read: ast.Call, place: Place, depth: int) -> Value:
        """Return the value of a parameter of ROS 2: that which launch gives it, or else that of its declaration."""
        try:
            name = self.text(written, place)
        except UnknownValueError:
            raise UnknownValueError(f"it is the parameter '{_text(written)}'") from None
        self.reads.add(name)
        unknown = f"it is the parameter '{name}'"
        found = [each for each in declarations(place.classes) if self._is_named(each, name, place)]
        if (isinstance(read.func, ast.Attribute) and read.func.attr == "get_parameter_or") or len(found) != 1:
            raise UnknownValueError(unknown)
        if sets_parameters(place.classes) or self._has_options(place, depth):
            raise UnknownValueError(f"{unknown}, and the node sets parameters itself")
        if name in self._given.unknown or (self._given.is_open and name not in self._given.values):
            raise UnknownValueError(f"{unknown}, and what launch gives it is not known")
        declared = found[0]
        own = Place(declared.module, place.classes, declared.method)
        if name not in self._given.values:
            return self._default(unknown, declared, own, depth)
        given = self._given.values[name]
        if not declared.overrides or not isinstance(given, (str, int, float, bool)):
            raise UnknownValueError(f"{unknown}, and launch gives it {given!r}")
        self._refuse_other_type(unknown, declared, own, given, depth)
        return given

    def _has_options(self, place: Place, depth: int) -> bool:
        """Return whether a constructor gives the node parameters itself, or keeps those of launch from it."""
        for module, method, given in options(place.classes):
            try:
                if self.value(given, Place(module, place.classes, method), depth + 1) not in (None, True):
                    return True
            except UnknownValueError:
                return True
        return False

    def _default(self, unknown: str, declared: Declaration, own: Place, depth: int) -> Value:
        if declared.default is None:
            raise UnknownValueError(f"{unknown}, which nothing sets")
        try:
            value = self.value(declared.default, own, depth + 1)
        except UnknownValueError as problem:
            raise UnknownValueError(f"{unknown}, and nothing but '{_text(declared.default)}' sets it") from problem
        if value is None:
            raise UnknownValueError(f"{unknown}, which nothing sets")
        return value

    def _refuse_other_type(self, unknown: str, declared: Declaration, own: Place, given: object, depth: int) -> None:
        """Refuse a value of another type than the default, with which a node does not start."""
        try:
            default = self._default(unknown, declared, own, depth)
        except UnknownValueError:
            return
        if type(default) is not type(given):
            raise UnknownValueError(f"{unknown}, which is {default!r} by default, and launch gives it {given!r}")

    def _is_named(self, declared: Declaration, name: str, place: Place) -> bool:
        own = Place(declared.module, place.classes, declared.method)
        try:
            prefix = self.text(declared.prefix, own) if declared.prefix is not None else ""
            return name == (f"{prefix}." if prefix else "") + self.text(declared.name, own)
        except UnknownValueError:
            return False

    def _only(self, found: list[tuple[Binding, Module]], name: str, place: Place) -> tuple[ast.expr, Place]:
        if len(found) != 1:
            raise UnknownValueError(f"'{name}' is given in {len(found) or 'no'} places")
        binding, module = found[0]
        if binding.value is None:
            raise UnknownValueError(f"'{name}' changes")
        classes = place.classes if binding.function is not None or module is place.module else ()
        return binding.value, Place(module, classes, binding.function)

    def _field(self, name: str, place: Place) -> tuple[ast.expr, Place]:
        found = [(each, module) for module, cls in place.classes for each in fields(cls).get(name, [])]
        return self._only(found, f"self.{name}", place)

    def _name(self, name: str, place: Place) -> tuple[ast.expr, Place]:
        if place.function is not None:
            local = bindings(place.function.body, place.function).get(name)
            if name in parameters(place.function):
                given = self._passed.get(place.function, {}).get(name)
                if given is None or local:
                    raise UnknownValueError(f"'{name}' is a parameter of {place.function.name}()")
                return given
            if local:
                return self._only([(each, place.module) for each in local], name, place)
        return self._global(place.module, name, place)

    def _global(self, module: Module, name: str, place: Place) -> tuple[ast.expr, Place]:
        if name in module.names:
            return self._only([(each, module) for each in module.names[name]], name, Place(module))
        owner = self._modules.owner(module.imports.get(name, ""))
        if owner is not None and owner[1] in owner[0].names:
            found = [(each, owner[0]) for each in owner[0].names[owner[1]]]
            return self._only(found, name, Place(owner[0]))
        raise UnknownValueError(f"'{name}' is defined elsewhere")

    def _attribute(self, node: ast.Attribute, place: Place) -> tuple[ast.expr, Place]:
        cls = self._modules.class_named(place.module, node.value)
        if cls is not None:
            body = bindings(cls[1].body, None).get(node.attr, [])
            return self._only([(each, cls[0]) for each in body], _text(node), Place(cls[0]))
        owner = self._modules.owner(place.module.full_name(node) or "")
        if owner is not None and owner[1] in owner[0].names:
            return self._global(owner[0], owner[1], Place(owner[0]))
        inner = value_of(node)
        for _ in range(_DEEPEST):
            if inner is None or isinstance(inner, ast.Call):
                break
            inner, place = self.definition(inner, place)
        if inner is not None and parameter_of(inner) is not None:
            return inner, place
        raise UnknownValueError(f"it is '{_text(node)}'")


def passed(function: Function, call: ast.Call | None, place: Place, own: Place) -> dict[str, tuple[ast.expr, Place]]:
    """Return what a call gives the parameters of a function, and what they are by default; no call gives nothing.

    Args:
        function: the function.
        call: its call.
        place: the scope of the call.
        own: the scope of the defaults; that of a class for a method, whose first parameter is the object.

    """
    taken = function.args
    plain = [each.arg for each in (*taken.posonlyargs, *taken.args)]
    defaults = list(zip(reversed(plain), reversed(taken.defaults), strict=False))
    defaults += [(each.arg, value) for each, value in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if value]
    found = {name: (value, own) for name, value in defaults}
    if call is None:
        return found
    if any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords):
        return {}
    for name, value in zip(plain[1 if own.classes else 0 :], call.args, strict=False):
        found[name] = (value, place)
    found.update({each.arg: (each.value, place) for each in call.keywords if each.arg is not None})
    return found


def _number(value: Value) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise UnknownValueError(f"it is {value!r}, which is no number")
    if abs(value) > 1e15:
        raise UnknownValueError("it is too large")
    return value


def _text(node: ast.AST) -> str:
    text = ast.unparse(node)
    return text if len(text) <= 60 else text[:57] + "..."
