"""Fields of messages that a class reads and writes, where its source says so.

A message that goes to where its use cannot be followed has no known fields: all of them may be used.
"""

from __future__ import annotations

import ast

from source_modules import FUNCTIONS, Function, is_self_attribute, parameters

Name = tuple[str, str]
"""A variable that holds a message: the function that it is local to, or `self`, and its name."""

_SELF = "self"


class MessageUse:
    """The uses of messages in the methods of a class, or in one function."""

    def __init__(self, functions: list[Function]) -> None:
        self._functions = functions
        self._parents: dict[ast.AST, ast.AST] = {}
        self._uses: dict[Name, list[ast.expr]] = {}
        self._published: dict[str, list[tuple[ast.Call, Function]]] = {}
        for function in functions:
            for node in ast.walk(function):
                self._parents.update(dict.fromkeys(ast.iter_child_nodes(node), node))
                self._index(node, function)

    def _index(self, node: ast.AST, function: Function) -> None:
        """Keep what reads a variable, and what publishes."""
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
            self._uses.setdefault((function.name, node.id), []).append(node)
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load) and is_self_attribute(node):
            self._uses.setdefault((_SELF, node.attr), []).append(node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "publish":
            self._published.setdefault(ast.unparse(node.func.value), []).append((node, function))

    def read(self, callback: ast.expr) -> list[str] | None:
        """Return the paths that a callback and the methods that it hands its message to read; None if unknown."""
        function = self._method(callback)
        names = _message_parameters(function) if function is not None else []
        if function is None or not names or not isinstance(function, FUNCTIONS):
            return None
        return self._paths((function.name, names[0]))

    def written(self, publisher: ast.AST) -> list[str] | None:
        """Return the paths that are set in what is published through a variable; None if unknown.

        Args:
            publisher: the target that the publisher is assigned to.

        """
        found: list[str] = []
        calls = self._published.get(ast.unparse(publisher), [])
        for call, function in calls:
            paths = self._of_message(call.args[0], function) if len(call.args) == 1 else None
            if paths is None:
                return None
            found += paths
        return found if calls else None

    def _method(self, callback: ast.expr) -> Function | None:
        name = ""
        if is_self_attribute(callback):
            assert isinstance(callback, ast.Attribute)
            name = callback.attr
        elif isinstance(callback, ast.Name):
            name = callback.id
        return next((function for function in self._functions if function.name == name), None)

    def _of_message(self, node: ast.expr, function: Function) -> list[str] | None:
        """Return the paths that are set in a message that is published."""
        if isinstance(node, ast.Call):
            return _keywords(node)
        if not isinstance(node, ast.Name) or node.id in parameters(function):
            return None
        made = [
            each.value
            for each in ast.walk(function)
            if isinstance(each, ast.Assign) and any(ast.unparse(target) == node.id for target in each.targets)
        ]
        paths: list[str] = []
        for value in made:
            keywords = _keywords(value) if isinstance(value, ast.Call) else None
            if keywords is None:
                return None
            paths += keywords
        uses = self._paths((function.name, node.id), published=True)
        return [*paths, *uses] if made and uses is not None else None

    def _paths(self, first: Name, *, published: bool = False) -> list[str] | None:
        """Follow a message from variable to variable; return the paths of the attributes that are used of it."""
        found: list[str] = []
        pending, seen = [first], {first}
        while pending:
            name = pending.pop()
            for use in self._uses.get(name, []):
                path = self._path(use)
                if path:
                    found.append(path)
                    continue
                alias = self._alias(use)
                if alias is not None and not published:
                    pending += {alias} - seen
                    seen.add(alias)
                elif not self._is_harmless(use, published):
                    return None
        return found

    def _path(self, node: ast.expr) -> str:
        """Return the attributes behind a variable; empty if it is used as a whole."""
        path: list[str] = []
        current: ast.AST = node
        while True:
            parent = self._parents.get(current)
            if not isinstance(parent, ast.Attribute):
                return ".".join(path)
            path.append(parent.attr)
            current = parent

    def _alias(self, node: ast.expr) -> Name | None:
        """Return the variable that a variable is assigned to as a whole, or handed to."""
        parent = self._parents.get(node)
        if isinstance(parent, ast.Assign) and parent.value is node and len(parent.targets) == 1:
            target = parent.targets[0]
            if is_self_attribute(target):
                assert isinstance(target, ast.Attribute)
                return _SELF, target.attr
            if isinstance(target, ast.Name):
                return self._function_of(node), target.id
        if isinstance(parent, ast.Call) and parent.args == [node]:
            called = self._method(parent.func) if is_self_attribute(parent.func) else None
            names = _message_parameters(called) if called is not None else []
            if called is not None and len(names) == 1:
                return called.name, names[0]
        return None

    def _function_of(self, node: ast.AST) -> str:
        current: ast.AST | None = node
        while current is not None:
            if current in self._functions and isinstance(current, FUNCTIONS):
                return current.name
            current = self._parents.get(current)
        return ""

    def _is_harmless(self, node: ast.expr, published: bool) -> bool:
        """Return whether a message as a whole is only compared with None, tested, or published."""
        parent = self._parents.get(node)
        if isinstance(parent, ast.Compare):
            others = [each for each in (parent.left, *parent.comparators) if each is not node]
            return all(isinstance(each, ast.Constant) and each.value is None for each in others)
        if isinstance(parent, (ast.BoolOp, ast.If, ast.While, ast.IfExp)) or (
            isinstance(parent, ast.UnaryOp) and isinstance(parent.op, ast.Not)
        ):
            return not isinstance(parent, ast.IfExp) or parent.test is node
        return (
            published
            and isinstance(parent, ast.Call)
            and isinstance(parent.func, ast.Attribute)
            and parent.func.attr == "publish"
        )


def _message_parameters(function: Function) -> list[str]:
    arguments = [each.arg for each in (*function.args.posonlyargs, *function.args.args)]
    return arguments[1:] if arguments[:1] == [_SELF] else arguments


def _keywords(call: ast.Call) -> list[str] | None:
    """Return the fields that a call sets which makes a message; None where it need not be one."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    if call.args or not name[:1].isupper() or any(each.arg is None for each in call.keywords):
        return None
    return [str(each.arg) for each in call.keywords]
