"""Tell whether a function does the same with two of its parameters exchanged, whatever their values are.

Such an exchange is no defect: four doors of which any may be open are a question of the doors, not of their order. The
parameters are renamed into each other, and what has no order is sorted: operands of `and` and `or` that are Booleans,
or of which only the truth counts, both sides of `==`, and sequences of which it only counts what is in them. Only
expressions are sorted whose evaluation has no effect and raises nothing, so that a function that is called symmetric
is symmetric; one that is not may be symmetric for another reason.
"""

from __future__ import annotations

import ast
import copy
from typing import Any

_HARMLESS = {"abs", "bool", "isfinite", "isinf", "isnan"}
"""Functions that raise nothing for a number."""

_SEQUENCE = (ast.Tuple, ast.List, ast.Set)
_COMPREHENSION = (ast.GeneratorExp, ast.ListComp, ast.SetComp)


def is_symmetric(function: ast.FunctionDef | ast.AsyncFunctionDef, first: str, second: str, booleans: set[str]) -> bool:
    """Return whether the body of a function does the same with two parameters exchanged.

    ``booleans`` are the parameters that are true or false, of which both or none of the two are.
    """
    if _rebinds(function, {first, second}):
        return False
    names = {first: second, second: first}
    bodies = [function.body, [_Renaming(names).visit(copy.deepcopy(each)) for each in function.body]]
    return len({_sorted(body, booleans) for body in bodies}) == 1


def _rebinds(function: ast.AST, names: set[str]) -> bool:
    """Return whether something within a function gives one of the names a meaning of its own."""
    parameters = function.args if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)) else None
    bound: set[str] = set()
    for node in ast.walk(function):
        if isinstance(node, ast.arguments) and node is not parameters:
            bound |= {each.arg for each in ast.walk(node) if isinstance(each, ast.arg)}
        if isinstance(node, (ast.Global, ast.Nonlocal)):
            bound |= set(node.names)
    return bool(names & bound)


def _sorted(body: list[ast.stmt], booleans: set[str]) -> str:
    tree = ast.Module(copy.deepcopy(body), [])
    return ast.dump(_Sorting(booleans, _unordered(tree)).visit(tree))


class _Renaming(ast.NodeTransformer):
    """Gives variables other names."""

    def __init__(self, names: dict[str, str]) -> None:
        self._names = names

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Return the variable under its new name."""
        return ast.Name(self._names.get(node.id, node.id), node.ctx)


class _Sorting(ast.NodeTransformer):
    """Sorts what has no order."""

    def __init__(self, booleans: set[str], unordered: set[int]) -> None:
        self._booleans = booleans
        self._unordered = unordered

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        """Sort operands that are Booleans."""
        self.generic_visit(node)
        if all(_is_total(each) and self._is_boolean(each) for each in node.values):
            node.values.sort(key=ast.dump)
        return node

    def visit_If(self, node: ast.If) -> Any:
        """Sort what is only asked whether it is true."""
        return self._tested(node)

    def visit_While(self, node: ast.While) -> Any:
        """Sort what is only asked whether it is true."""
        return self._tested(node)

    def visit_IfExp(self, node: ast.IfExp) -> Any:
        """Sort what is only asked whether it is true."""
        return self._tested(node)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """Sort what is only asked whether it is true."""
        self.generic_visit(node)
        if isinstance(node.op, ast.Not):
            node.operand = self._truth(node.operand)
        return node

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        """Sort the sides of a comparison for equality."""
        self.generic_visit(node)
        sides = [node.left, *node.comparators]
        if len(sides) == 2 and isinstance(node.ops[0], (ast.Eq, ast.NotEq)) and all(map(_is_total, sides)):
            node.left, *node.comparators = sorted(sides, key=ast.dump)
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Sort what is only asked whether it is true."""
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id == "bool" and len(node.args) == 1:
            node.args = [self._truth(node.args[0])]
        return node

    def visit(self, node: ast.AST) -> Any:
        """Sort the elements of a sequence of which it only counts what is in it."""
        unordered = id(node) in self._unordered
        visited = super().visit(node)
        if unordered and all(map(_is_total, visited.elts)):
            visited.elts.sort(key=ast.dump)
        return visited

    def _tested(self, node: Any) -> Any:
        self.generic_visit(node)
        node.test = self._truth(node.test)
        return node

    def _truth(self, node: ast.expr) -> Any:
        """Sort operands of which only the truth counts, since that of the whole does."""
        if isinstance(node, ast.BoolOp):
            node.values = [self._truth(each) for each in node.values]
            if all(map(_is_total, node.values)):
                node.values.sort(key=ast.dump)
        return node

    def _is_boolean(self, node: ast.expr) -> bool:
        if isinstance(node, ast.Name):
            return node.id in self._booleans
        if isinstance(node, ast.BoolOp):
            return all(self._is_boolean(each) for each in node.values)
        if isinstance(node, ast.Constant):
            return isinstance(node.value, bool)
        return isinstance(node, ast.Compare) or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not))


def _is_total(node: ast.expr) -> bool:
    """Return whether an expression of numbers, texts and Booleans has no effect and raises nothing."""
    if isinstance(node, (ast.Name, ast.Constant)):
        return True
    if isinstance(node, ast.Attribute):
        return isinstance(node.value, ast.Name) and node.value.id == "self"
    if isinstance(node, ast.BoolOp):
        return all(map(_is_total, node.values))
    if isinstance(node, ast.Compare):
        return all(map(_is_total, [node.left, *node.comparators]))
    if isinstance(node, ast.UnaryOp):
        return _is_total(node.operand)
    if isinstance(node, ast.BinOp):
        return isinstance(node.op, (ast.Add, ast.Sub, ast.Mult)) and _is_total(node.left) and _is_total(node.right)
    if isinstance(node, ast.Call):
        name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
        return name in _HARMLESS and not node.keywords and all(map(_is_total, node.args))
    return False


def _unordered(tree: ast.AST) -> set[int]:
    """Return the sequences of which it only counts what is in them, by their identities."""
    asked = [each for node in ast.walk(tree) for each in _asked(node)]
    found = {id(each) for each in asked if isinstance(each, _SEQUENCE)}
    only_asked = {id(each) for each in asked}
    for name, sequence in _assigned(tree).items():
        uses = [each for each in ast.walk(tree) if isinstance(each, ast.Name) and each.id == name]
        if all(isinstance(each.ctx, ast.Store) or id(each) in only_asked for each in uses):
            found.add(id(sequence))
    return found


def _assigned(tree: ast.AST) -> dict[str, ast.expr]:
    """Return the sequences that are the only value of a variable."""
    found: dict[str, ast.expr] = {}
    stored = [each.id for each in ast.walk(tree) if isinstance(each, ast.Name) and not isinstance(each.ctx, ast.Load)]
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.value, _SEQUENCE):
            target = node.targets[0]
            if isinstance(target, ast.Name) and stored.count(target.id) == 1:
                found[target.id] = node.value
    return found


def _asked(node: ast.AST) -> list[ast.expr]:
    """Return the expressions that a node asks what is in them, in any order."""
    if isinstance(node, ast.Compare) and isinstance(node.ops[-1], (ast.In, ast.NotIn)):
        return [node.comparators[-1]]
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name) or len(node.args) != 1 or node.keywords:
        return []
    argument = node.args[0]
    if node.func.id in ("any", "all", "len", "sum") and isinstance(argument, _COMPREHENSION):
        one = len(argument.generators) == 1 and not argument.generators[0].is_async
        exact = node.func.id != "sum" or isinstance(argument.elt, (ast.Compare, ast.Constant))
        parts = [argument.elt, *argument.generators[0].ifs]
        return [argument.generators[0].iter] if one and exact and all(map(_is_total, parts)) else []
    return [argument] if node.func.id in ("any", "all", "len") else []
