"""Values of expressions that are known without running anything."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable
from typing import NamedTuple

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
        passed: what is known of parameters.

    """

    def __init__(self, modules: Modules, passed: Passed | None = None) -> None:
        self._modules = modules
        self._passed = passed or {}

    def with_parameters(self, passed: Passed) -> Constants:
        """Return these constants with what is known of parameters."""
        return Constants(self._modules, passed)

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
            return self.value(inner, there, depth + 1)
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
            try:
                name = self.text(parameter, place)
            except UnknownValueError:
                name = _text(parameter)
            raise UnknownValueError(f"it is the parameter '{name}'{self._default(name, node, place)}")
        if isinstance(node.func, ast.Name) and len(node.args) == 1 and not node.keywords:
            value = self.value(node.args[0], place, depth + 1)
            if node.func.id == "str":
                return str(value)
            if node.func.id == "float":
                return float(_number(value))
        raise UnknownValueError(f"it is '{_text(node)}'")

    def _default(self, name: str, read: ast.Call, place: Place) -> str:
        """Return what is said about the default of a parameter: a clause, or nothing."""
        trees = [read, *(cls for _, cls in place.classes)]
        for call in (each for tree in trees for each in ast.walk(tree) if isinstance(each, ast.Call)):
            declares = isinstance(call.func, ast.Attribute) and call.func.attr == "declare_parameter"
            if declares and len(call.args) > 1 and ast.unparse(call.args[0]) == repr(name):
                return f", by default {ast.unparse(call.args[1])}"
        return ""

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
        inner = node.value
        if node.attr in ("value", "string_value", "double_value", "integer_value") and isinstance(inner, ast.Call):
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


def parameter_of(node: ast.expr) -> ast.expr | None:
    """Return the name of the parameter that a call reads: ``self.get_parameter(NAME).get_parameter_value()``."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr in ("get_parameter", "declare_parameter", "get_parameter_or") and node.args:
            return node.args[0]
        if node.func.attr == "get_parameter_value":
            return parameter_of(node.func.value)
    return None


def _number(value: Value) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise UnknownValueError(f"it is {value!r}, which is no number")
    if abs(value) > 1e15:
        raise UnknownValueError("it is too large")
    return value


def _text(node: ast.AST) -> str:
    text = ast.unparse(node)
    return text if len(text) <= 60 else text[:57] + "..."
