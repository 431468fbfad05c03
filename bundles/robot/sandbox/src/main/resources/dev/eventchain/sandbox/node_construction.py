"""Construction of a node that is hosted as it is: the arguments that the file of its class makes it with.

They are read from the call of the class outside of classes, such as in `main`, or else in other classes, and none of
the code is run. An argument is known if it is made of literals and of names that are given once, in the function of the
call, in one around it, or in the file.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

RULE = "component.node.arguments"

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_DEEPEST = 40
_LONGEST = 10_000
_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}

Function = ast.FunctionDef | ast.AsyncFunctionDef
Functions = tuple[Function | ast.Lambda, ...]
"""Functions around a place, innermost first."""


class Construction(NamedTuple):
    """Call of a class, with the values of its arguments."""

    call: ast.Call
    positional: tuple[Any, ...]
    named: dict[str, Any]


class UnknownConstructionError(Exception):
    """Arguments that the source does not say, with the place and a sentence."""

    def __init__(self, node: ast.AST, message: str) -> None:
        super().__init__(message)
        self.node = node


class Problem(NamedTuple):
    """A fault in the arguments of a node; uncertain if it runs all the same."""

    node: ast.AST
    message: str
    hint: str
    certain: bool


def read(tree: ast.Module, class_name: str) -> Construction | None:
    """Return how a file makes an instance of one of its classes; None if it does not.

    Raises:
        UnknownConstructionError: an argument is not known, or it makes instances in several ways.

    """
    found: Construction | None = None
    for call, functions in _calls(tree, class_name):
        made = _construction(call, _Scope(tree, functions), class_name)
        if found is None:
            found = made
        elif repr(found[1:]) != repr(made[1:]):
            message = f"{class_name} is made with other arguments in line {found.call.lineno} than here."
            raise UnknownConstructionError(call, message)
    return found


def problems(tree: ast.Module, class_name: str, given: dict[str, Any] | None) -> Iterator[Problem]:
    """Find what is wrong with the arguments of a node.

    Args:
        tree: the file of its class.
        class_name: its class.
        given: the arguments that its description gives by name; None if it gives none.

    """
    if any(node.name == class_name and not node.bases for node in _classes(tree)):
        return  # no node of rclpy, but a class that is given a DDS participant
    constructor = _constructor(tree, class_name)
    if given is not None:
        yield from _given(tree, class_name, constructor, given)
        return
    needed = _required(constructor) if constructor is not None else []
    hint = _hint(class_name, needed)
    try:
        if read(tree, class_name) is None and constructor is not None and needed:
            message = f"{class_name}() needs {_listed(needed)}, and nothing in this file makes one."
            yield Problem(constructor, message, hint, True)
    except UnknownConstructionError as unknown:
        if needed or constructor is None:
            yield Problem(unknown.node, str(unknown), hint, constructor is not None)
        else:
            yield Problem(unknown.node, f"{unknown} It is hosted with the defaults.", hint, False)


def _given(tree: ast.Module, class_name: str, constructor: Function | None, given: dict[str, Any]) -> Iterator[Problem]:
    if constructor is not None:
        known = [*_parameters(constructor), *(each.arg for each in constructor.args.kwonlyargs)]
        unknown = [] if constructor.args.kwarg else [name for name in given if name not in known]
        missing = [name for name in _required(constructor) if name not in given]
        if unknown:
            message = f"components.json gives {class_name}() {_listed(unknown)}, which it does not take."
            yield Problem(constructor, message, f"It takes {_listed(known) or 'nothing'}.", True)
        if missing:
            message = f"{class_name}() needs {_listed(missing)}, which components.json does not give it."
            yield Problem(constructor, message, _hint(class_name, missing), True)
    try:
        made = read(tree, class_name)
    except UnknownConstructionError:
        return  # that is why they are given
    if made is None:
        return
    names = _parameters(constructor) if constructor is not None else []
    here = {**dict(zip(names, made.positional, strict=False)), **made.named}
    differing = [name for name in {**here, **given} if name not in here or name not in given]
    differing += [name for name in here if name in given and _in_json(here[name]) != given[name]]
    if differing and len(made.positional) <= len(names):
        message = f"components.json makes {class_name} with other arguments than this: {_listed(sorted(differing))}."
        hint = "It is hosted with those of components.json. Remove 'arguments' there to take these."
        yield Problem(made.call, message, hint, False)


def _in_json(value: Any) -> Any:
    """Return a value as JSON has it."""
    if isinstance(value, (list, tuple)):
        return [_in_json(each) for each in value]
    return {str(key): _in_json(each) for key, each in value.items()} if isinstance(value, dict) else value


def _hint(class_name: str, needed: list[str]) -> str:
    names = ", ".join(f'"{name}": ...' for name in needed) or '"NAME": ...'
    return (
        "Write literals, or names that are given once. Or say it in components.json: "
        f'"node": {{"class": "{class_name}", "arguments": {{{names}}}}}.'
    )


def _listed(names: Iterable[str]) -> str:
    return " and ".join(f"'{name}'" for name in names)


# Calls


def _calls(tree: ast.Module, class_name: str) -> list[tuple[ast.Call, Functions]]:
    """Return the calls of a class outside of classes, or else in other ones, each with the functions around it."""
    others = [each for cls in _classes(tree) if cls.name != class_name for each in cls.body]
    return list(_calls_in(tree.body, class_name)) or list(_calls_in(others, class_name))


def _calls_in(body: Iterable[ast.AST], class_name: str) -> Iterator[tuple[ast.Call, Functions]]:
    pending: list[tuple[ast.AST, Functions]] = [(node, ()) for node in body]
    while pending:
        node, functions = pending.pop(0)
        if isinstance(node, ast.ClassDef):
            continue
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == class_name:
            yield node, functions
        inner = (node, *functions) if isinstance(node, (*_FUNCTIONS, ast.Lambda)) else functions
        pending[:0] = [(child, inner) for child in ast.iter_child_nodes(node)]


def _construction(call: ast.Call, scope: _Scope, class_name: str) -> Construction:
    positional = [scope.value(each, class_name) for each in call.args]
    named = {}
    for keyword in call.keywords:
        if keyword.arg is None:
            raise UnknownConstructionError(keyword.value, _unknown(class_name, keyword.value))
        named[keyword.arg] = scope.value(keyword.value, class_name)
    return Construction(call, tuple(positional), named)


def _unknown(class_name: str, node: ast.AST) -> str:
    text = ast.unparse(node)
    short = text if len(text) <= 60 else text[:57] + "..."
    return f"An argument of {class_name}() is not known before it runs: '{short}'."


# Values


class _Scope:
    """Names where a call is."""

    def __init__(self, tree: ast.Module, functions: Functions) -> None:
        self._tree = tree
        self._functions = functions

    def value(self, node: ast.expr, class_name: str) -> Any:
        try:
            return self._value(node, 0)
        except (_UnknownError, ArithmeticError, TypeError, ValueError):
            raise UnknownConstructionError(node, _unknown(class_name, node)) from None

    def _value(self, node: ast.expr, depth: int) -> Any:
        if depth > _DEEPEST:
            raise _UnknownError
        if isinstance(node, ast.Constant) and node.value is not Ellipsis:
            return node.value
        if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
            kind = {ast.List: list, ast.Tuple: tuple, ast.Set: set}[type(node)]
            return kind(self._value(each, depth + 1) for each in node.elts)
        if isinstance(node, ast.Dict):
            return dict(
                zip(self._keys(node, depth), (self._value(each, depth + 1) for each in node.values), strict=True)
            )
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -_number(self._value(node.operand, depth + 1))
        if isinstance(node, ast.BinOp):
            return self._operation(node, depth)
        if isinstance(node, ast.Name):
            return self._named(node.id, depth)
        raise _UnknownError

    def _keys(self, node: ast.Dict, depth: int) -> list[Any]:
        if None in node.keys:
            raise _UnknownError
        return [self._value(key, depth + 1) for key in node.keys if key is not None]

    def _operation(self, node: ast.BinOp, depth: int) -> Any:
        left, right = (self._value(side, depth + 1) for side in (node.left, node.right))
        apply = _OPERATORS.get(type(node.op))
        if apply is None:
            raise _UnknownError
        if isinstance(left, str) and isinstance(right, str) and apply is operator.add:
            if len(left) + len(right) > _LONGEST:
                raise _UnknownError
            return left + right
        return apply(_number(left), _number(right))

    def _named(self, name: str, depth: int) -> Any:
        scope, given = _Scope(self._tree, ()), _given_in(self._tree.body, name)
        for number, function in enumerate(self._functions):
            local = [] if isinstance(function, ast.Lambda) else _given_in(function.body, name)
            if name in _all_parameters(function):
                return self._default(number, name, local, depth)
            if local:
                scope, given = _Scope(self._tree, self._functions[number:]), local
                break
        if len(given) != 1 or given[0] is None or _is_global(self._tree, name):
            raise _UnknownError
        value = scope._value(given[0], depth + 1)
        if isinstance(value, (list, set, dict)) and _reads(self._tree, name) > 1:
            raise _UnknownError  # it may be changed before the call
        return value

    def _default(self, number: int, name: str, given: list[ast.expr | None], depth: int) -> Any:
        """Return the default of a parameter of a function that nothing in the file calls with arguments."""
        function = self._functions[number]
        if isinstance(function, ast.Lambda):
            raise _UnknownError
        calls = (each for each in ast.walk(self._tree) if isinstance(each, ast.Call))
        own = [each for each in calls if isinstance(each.func, ast.Name) and each.func.id == function.name]
        default = _defaults(function).get(name)
        if given or default is None or any(each.args or each.keywords for each in own):
            raise _UnknownError
        return _Scope(self._tree, self._functions[number + 1 :])._value(default, depth + 1)


class _UnknownError(Exception):
    """A value that is not known."""


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or abs(value) > 1e15:
        raise _UnknownError
    return value


def _own(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Return the nodes of a block, without those of functions and classes in it."""
    for node in body:
        yield node
        if not isinstance(node, (*_FUNCTIONS, ast.ClassDef, ast.Lambda)):
            yield from _own(ast.iter_child_nodes(node))


def _given_in(body: Iterable[ast.AST], name: str) -> list[ast.expr | None]:
    """Return what a block gives a name; None where that is no single expression, as in a loop or an import."""
    nodes = list(_own(body))
    found: list[ast.expr | None] = []
    plain: set[ast.AST] = set()
    for node in nodes:
        if isinstance(node, ast.Assign):
            targets = [each for each in node.targets if isinstance(each, ast.Name) and each.id == name]
            plain.update(targets)
            found += [node.value for _ in targets]
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.target.id == name:
            plain.add(node.target)
            found += [node.value] if node.value is not None else []
        elif name in _bound(node):
            found.append(None)
    others = [each for each in nodes if isinstance(each, ast.Name) and each.id == name and each not in plain]
    return found + [None for each in others if not isinstance(each.ctx, ast.Load)]


def _bound(node: ast.AST) -> tuple[str, ...]:
    """Return the name that a definition, an import, a handler of exceptions or a pattern binds."""
    if isinstance(node, ast.alias):
        return (node.asname or node.name.partition(".")[0],)
    if isinstance(node, (*_FUNCTIONS, ast.ClassDef, ast.ExceptHandler, ast.MatchAs, ast.MatchStar)):
        return (node.name or "",)
    return ()


def _is_global(tree: ast.Module, name: str) -> bool:
    return any(isinstance(node, (ast.Global, ast.Nonlocal)) and name in node.names for node in ast.walk(tree))


def _reads(tree: ast.Module, name: str) -> int:
    loads = (node for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load))
    return sum(node.id == name for node in loads)


# Constructors


def _classes(tree: ast.Module) -> list[ast.ClassDef]:
    return [node for node in _own(tree.body) if isinstance(node, ast.ClassDef)]


def _constructor(tree: ast.Module, class_name: str) -> Function | None:
    """Return the constructor of a class, which may be that of a base in the file; None if it is elsewhere."""
    classes = {node.name: node for node in _classes(tree)}
    seen: set[str] = set()
    pending = [class_name]
    while pending:
        name = pending.pop(0)
        if name not in classes or name in seen or classes[name].decorator_list:
            return None
        seen.add(name)
        for node in reversed(classes[name].body):
            if isinstance(node, _FUNCTIONS) and node.name == "__init__":
                return None if node.decorator_list else node
        pending[:0] = [each.id if isinstance(each, ast.Name) else "" for each in classes[name].bases]
    return None


def _parameters(constructor: Function) -> list[str]:
    """Return the positional parameters of a constructor, without the object itself."""
    return [each.arg for each in (*constructor.args.posonlyargs, *constructor.args.args)][1:]


def _all_parameters(function: Function | ast.Lambda) -> set[str]:
    taken = function.args
    named = [*taken.posonlyargs, *taken.args, *taken.kwonlyargs, taken.vararg, taken.kwarg]
    return {each.arg for each in named if each is not None}


def _defaults(function: Function) -> dict[str, ast.expr]:
    taken = function.args
    plain = [*taken.posonlyargs, *taken.args]
    last = plain[len(plain) - len(taken.defaults) :]
    found = {each.arg: default for each, default in zip(last, taken.defaults, strict=True)}
    named = zip(taken.kwonlyargs, taken.kw_defaults, strict=True)
    return {**found, **{each.arg: default for each, default in named if default is not None}}


def _required(constructor: Function) -> list[str]:
    defaults = _defaults(constructor)
    named = [each.arg for each in constructor.args.kwonlyargs]
    return [name for name in (*_parameters(constructor), *named) if name not in defaults]
