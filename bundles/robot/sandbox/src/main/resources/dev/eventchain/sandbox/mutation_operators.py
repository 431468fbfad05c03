"""Operators of mutation: what a defect makes of one node of a component's syntax tree."""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from typing import NamedTuple

ATOMS = (ast.Name, ast.Constant, ast.Call, ast.Attribute, ast.Subscript)
"""Expressions that need no parentheses anywhere."""

_BOUNDARY: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
}
_NEGATED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE,
    ast.LtE: ast.Gt,
    ast.Gt: ast.LtE,
    ast.GtE: ast.Lt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
_OPPOSITE: dict[type[ast.operator], type[ast.operator]] = {ast.Add: ast.Sub, ast.Sub: ast.Add}

_CONVERSIONS = {"radians", "degrees", "deg2rad", "rad2deg"}
_FACTORS = (3.6, 60, 3600, 100, 0.01, 1e3, 1e-3, 1e6, 1e-6, 1e9, 1e-9, 180 / math.pi, math.pi / 180)
"""Numbers by which a value of one unit becomes one of another: km/h, minutes, percent, milli, degrees."""
_PERCENT = (1, 10)


class Change(NamedTuple):
    """An expression and what it becomes."""

    operator: str
    node: ast.expr
    new: ast.expr


def of_node(node: ast.AST, parent: ast.AST | None) -> Iterator[Change]:
    """Yield what the operators make of a node itself, without its parts."""
    if isinstance(node, ast.Compare):
        yield from _comparison(node)
    elif isinstance(node, ast.UnaryOp):
        yield from _unary(node)
    elif isinstance(node, ast.BinOp):
        yield from _arithmetic(node)
    elif isinstance(node, ast.BoolOp):
        yield from _dropped_condition(node)
    elif isinstance(node, (ast.If, ast.While, ast.IfExp)):
        yield from _branch(node)
    elif isinstance(node, ast.Constant):
        yield from _constant(node, parent)
    elif isinstance(node, ast.Call):
        yield from _call(node)
    elif isinstance(node, ast.Subscript):
        yield from _index(node.slice)
    elif isinstance(node, ast.AugAssign) and type(node.op) in _OPPOSITE:
        # The operator has no place of its own; the value with the other sign is the same.
        yield Change("sign", node.value, ast.UnaryOp(ast.USub(), node.value))


def _comparison(node: ast.Compare) -> Iterator[Change]:
    for position, operator in enumerate(node.ops):
        for table in (_BOUNDARY, _NEGATED):
            other = table.get(type(operator))
            if other is not None:
                operators = [*node.ops[:position], other(), *node.ops[position + 1 :]]
                yield Change("comparison", node, ast.Compare(node.left, operators, node.comparators))


def _unary(node: ast.UnaryOp) -> Iterator[Change]:
    if isinstance(node.op, ast.Not):
        yield Change("comparison", node, node.operand)
    elif isinstance(node.op, ast.USub):
        yield Change("sign", node, node.operand)


def _arithmetic(node: ast.BinOp) -> Iterator[Change]:
    opposite = _OPPOSITE.get(type(node.op))
    if opposite is not None and not (_is_text(node.left) or _is_text(node.right)):
        yield Change("sign", node, ast.BinOp(node.left, opposite(), node.right))
    if isinstance(node.op, (ast.Mult, ast.Div)):
        if _is_factor(node.right):
            yield Change("unit", node, node.left)
        elif isinstance(node.op, ast.Mult) and _is_factor(node.left):
            yield Change("unit", node, node.right)
        elif isinstance(node.op, ast.Div) and isinstance(node.left, ast.BinOp):
            yield from _angle(node, node.left)


def _angle(node: ast.BinOp, inner: ast.BinOp) -> Iterator[Change]:
    """Yield what is left of `x * pi / 180` and of `x * 180 / pi`."""
    if isinstance(inner.op, ast.Mult):
        for rest, factor in ((inner.left, inner.right), (inner.right, inner.left)):
            if _is_factor(ast.BinOp(factor, ast.Div(), node.right)):
                yield Change("unit", node, rest)


def _is_factor(node: ast.expr) -> bool:
    number = _number(node)
    return number is not None and any(math.isclose(number, factor, rel_tol=1e-3) for factor in _FACTORS)


def _number(node: ast.expr) -> float | None:
    """Return the value of a number, of pi, or of a quotient of them; None for anything else."""
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return float(node.value)  # type: ignore[arg-type]
    if isinstance(node, ast.Attribute) and node.attr == "pi":
        return math.pi
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
        left, right = _number(node.left), _number(node.right)
        return left / right if left is not None and right else None
    return None


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, (str, bytes)))


def _dropped_condition(node: ast.BoolOp) -> Iterator[Change]:
    for position in range(len(node.values)):
        rest = node.values[:position] + node.values[position + 1 :]
        yield Change("branch", node, rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest))


def _branch(node: ast.If | ast.While | ast.IfExp) -> Iterator[Change]:
    if isinstance(node, ast.IfExp):
        yield Change("branch", node, node.orelse)
        yield Change("branch", node, node.body)
        return
    yield Change("branch", node.test, ast.Constant(False))
    if isinstance(node, ast.If):
        if node.orelse:
            yield Change("branch", node.test, ast.Constant(True))
        elif isinstance(node.body[-1], (ast.Return, ast.Continue, ast.Break)):
            yield Change("return", node.test, ast.Constant(True))


def _constant(node: ast.Constant, parent: ast.AST | None) -> Iterator[Change]:
    if isinstance(node.value, bool):
        yield Change("constant", node, ast.Constant(not node.value))
    elif isinstance(node.value, (int, float)) and not _is_index(node, parent):
        for value in _near(node.value):
            yield Change("constant", node, ast.Constant(value))


def _is_index(node: ast.Constant, parent: ast.AST | None) -> bool:
    """Return whether another operator changes a number: that of indexes."""
    if isinstance(parent, ast.Call):
        return _range_end(parent) is not None or node is _popped(parent)
    return isinstance(parent, (ast.Subscript, ast.Slice))


def _near(value: int | float) -> list[int | float]:
    """Return the value a little larger and smaller; a whole number by 1 at least. Zero has no percent."""
    if value == 0 or not math.isfinite(value):
        return []
    found: list[int | float] = []
    for percent in _PERCENT:
        for sign in (1, -1):
            if isinstance(value, int):
                other: int | float = value + sign * max(1, round(abs(value) * percent / 100))
            else:
                other = float(f"{value * (1 + sign * percent / 100):.12g}")
            if other not in found:
                found.append(other)
    return found


def _call(node: ast.Call) -> Iterator[Change]:
    name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
    if name in _CONVERSIONS and len(node.args) == 1 and not node.keywords:
        yield Change("unit", node, node.args[0])
    end, popped = _range_end(node), _popped(node)
    if end is not None:
        yield Change("index", end, ast.BinOp(end, ast.Sub(), ast.Constant(1)))
    if popped is not None:
        yield from _index(popped)


def _range_end(node: ast.Call) -> ast.expr | None:
    if isinstance(node.func, ast.Name) and node.func.id == "range" and node.args:
        return node.args[0] if len(node.args) == 1 else node.args[1]
    return None


def _popped(node: ast.Call) -> ast.expr | None:
    """Return the index of an element that is removed or inserted."""
    is_list = isinstance(node.func, ast.Attribute) and node.func.attr in ("pop", "insert")
    return node.args[0] if is_list and node.args and _whole(node.args[0]) is not None else None


def _whole(node: ast.expr) -> int | None:
    if isinstance(node, ast.Constant) and type(node.value) is int:
        return node.value
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = _whole(node.operand)
        return -inner if inner is not None else None
    return None


def _index(node: ast.expr) -> Iterator[Change]:
    if isinstance(node, ast.Tuple):
        for element in node.elts:
            yield from _index(element)
    elif isinstance(node, ast.Slice):
        for bound in (node.lower, node.upper):
            if bound is not None:
                yield from _index(bound)
    else:
        number = _whole(node)
        for other in () if number is None else (number + 1, number - 1):
            if number is not None and (other < 0) == (number < 0):  # else the other end
                yield Change("index", node, ast.Constant(other))


def updates_state(node: ast.stmt) -> bool:
    """Return whether a statement only updates what a component remembers."""
    if isinstance(node, ast.Assign):
        return all(_is_state(target) for target in node.targets)
    if isinstance(node, (ast.AugAssign, ast.AnnAssign)):
        return node.value is not None and _is_state(node.target)
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and _is_state(node.value.func)


def _is_state(node: ast.expr) -> bool:
    if isinstance(node, (ast.Tuple, ast.List)):
        return all(_is_state(element) for element in node.elts)
    while isinstance(node, (ast.Attribute, ast.Subscript)):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            return node.value.id == "self"
        node = node.value
    return False


def own_returns(function: ast.AST) -> list[ast.Return]:
    """Return the `return` statements of a function, without those of functions in it."""
    found: list[ast.Return] = []
    for child in ast.iter_child_nodes(function):
        if isinstance(child, ast.Return):
            found.append(child)
        elif not isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            found += own_returns(child)
    return found


def returns_nothing(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Return whether a function is called for its effect only."""
    generates = any(isinstance(node, (ast.Yield, ast.YieldFrom)) for node in ast.walk(function))
    return not generates and all(each.value is None for each in own_returns(function))
