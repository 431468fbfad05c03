"""Static rules of hand-written files: components, nodes and modules that they import. None of their code is run.

They may import and call what they need, so only what their nodes need is checked, and what makes results differ from
run to run. Where a name comes from elsewhere (a base class of another file, a decorator), nothing is said about it.

As a program: standard input is a JSON object with ``sources``, a list of ``text``, and for a component its ``class``,
``inputs`` and ``outputs``; for a node that is hosted as it is ``node``, its class, which is empty for a module that
such nodes import, and ``arguments``, if its description gives some. Standard output is a JSON list with the findings of
each, with ``uncertain`` where a node may not come, or runs all the same.
"""

from __future__ import annotations

import ast
import difflib
import json
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import component_repeatability
import node_construction
import node_rules
from component_reach import MIDDLEWARE
from component_results import Output, check_keys
from component_rules import Component, Finding, Rules, decode, names, required, returns

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_PLAIN_BASES = frozenset({"object", "ABC", "Generic", "Protocol", "NamedTuple", "Enum"})
_PLAIN_DECORATORS = frozenset({"staticmethod", "classmethod", "override", "final", "dataclass", "abstractmethod"})
_NODES = frozenset({"Node", "LifecycleNode"})

NODE = "component.node"


class SourceRules(Rules):
    """Checks one hand-written file; as a component, if it is described as one.

    Args:
        source: text of the file.
        component: what its node needs; None for a module that components import.

    """

    def __init__(self, source: str, component: Component | None) -> None:
        super().__init__(source, component or Component("", [], []))
        self._described = component is not None

    def check(self) -> list[Finding]:
        """Return all findings, in the order of the file."""
        try:
            self._tree = ast.parse(self._source)
            found = [self._finding(*use) for use in component_repeatability.uses(self._tree)]
            found += [*self._relative_imports(), *(self._definition() if self._described else ())]
        except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
            return [self._syntax(problem)._replace(hint="")]
        return sorted(set(found), key=lambda each: (each.line, each.column, each.id, each.message))

    def _relative_imports(self) -> Iterator[Finding]:
        for node in ast.walk(self._tree):
            if isinstance(node, ast.ImportFrom) and node.level:
                message = "Components and the modules beside them are not in a package everywhere that they run."
                name = node.module or ", ".join(alias.name for alias in node.names)
                hint = f"Import it without dots, by its name: {name}."
                yield self._finding("component.import.helper", node, message, hint)

    def _definition(self) -> Iterator[Finding]:
        cls = self._class()
        if cls is None:
            if not self._is_bound():
                yield self._no_class()
            return
        if self._is_node(cls):
            yield self._node(cls, f"The class '{cls.name}' is a ROS 2 node, not a component.")
            return
        execute = self._method(cls, "execute")
        if execute is not None and _is_plain(execute):
            yield from self._execute(execute)
        elif execute is None and self._is_complete(cls):
            yield self._no_execute(cls)
        constructor = self._method(cls, "__init__")
        if constructor is not None and _is_plain(constructor) and required(constructor):
            message = f"{cls.name}() is made without arguments, but __init__ needs {', '.join(required(constructor))}."
            hint = "Give each parameter of __init__ a default, or make it a constant."
            yield self._finding("component.constructor.signature", constructor, message, hint)

    # Classes

    def _class_named(self, name: str) -> ast.ClassDef | None:
        found = [node for node in self._classes() if node.name == name]
        return found[-1] if found else None

    def _classes(self) -> Iterator[ast.ClassDef]:
        return (node for node in _statements(self._tree.body) if isinstance(node, ast.ClassDef))

    def _is_bound(self) -> bool:
        """Return whether the class may come from elsewhere: an import, or an assignment."""
        return _binds(_statements(self._tree.body), self._component.class_name)

    def _no_class(self) -> Finding:
        name = self._component.class_name
        others = list(self._classes())
        nodes = [other for other in others if self._is_node(other)]
        if nodes:
            return self._node(nodes[0], f"The file defines the ROS 2 node '{nodes[0].name}', and no class '{name}'.")
        message = f"The file does not define the class '{name}'."
        likely = _likely(name, [other.name for other in others])
        place = next((other for other in others if other.name == likely), others[0] if others else None)
        if place is None and self._middleware():
            return self._node(self._middleware()[0], f"{message[:-1]}, but uses middleware itself.")
        hint = f"Did you mean '{likely}'? Name the class '{name}'." if likely else f"Name the class '{name}'."
        return Finding("component.class.missing", *(self._place(place) if place else (1, 1)), message, hint)

    def _no_execute(self, cls: ast.ClassDef) -> Finding:
        message = f"The class '{cls.name}' has no method execute()."
        if self._middleware():
            return self._node(cls, f"{message[:-1]}, but its file uses middleware itself.")
        methods = [node for node in cls.body if isinstance(node, _FUNCTIONS) and not node.name.startswith("__")]
        likely = _likely("execute", [method.name for method in methods])
        only = methods[0].name if len(methods) == 1 else likely
        place = next((method for method in methods if method.name == only), cls)
        found = self._signature(place, message)
        return found._replace(hint=f"Did you mean '{only}'? {found.hint}") if only else found

    def _middleware(self) -> list[ast.stmt]:
        """Return the imports of middleware."""
        found: list[ast.stmt] = []
        for node in ast.walk(self._tree):
            modules = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom) and not node.level:
                modules = [node.module or ""]
            if isinstance(node, ast.stmt) and any(name.partition(".")[0] in MIDDLEWARE for name in modules):
                found.append(node)
        return found

    def _is_node(self, cls: ast.ClassDef) -> bool:
        """Return whether a class is derived from a node of ROS 2, also through another class of the file."""
        imported = {
            name
            for node in ast.walk(self._tree)
            if isinstance(node, (ast.Import, ast.ImportFrom))
            for name, full in component_repeatability.bound(node)
            if full.partition(".")[0] == "rclpy"
        }
        seen: set[str] = set()
        pending = [cls]
        while pending:
            current = pending.pop()
            seen.add(current.name)
            for base in current.bases:
                last = base.attr if isinstance(base, ast.Attribute) else base.id if isinstance(base, ast.Name) else ""
                if imported & {_first(base)} and (isinstance(base, ast.Name) or last in _NODES):
                    return True
                above = self._class_named(last) if isinstance(base, ast.Name) else None
                if above is not None and last not in seen:
                    pending.append(above)
        return False

    def _node(self, node: ast.AST, message: str) -> Finding:
        expected = ", ".join(["self", *self._component.inputs])
        hint = (
            f"A component is a class with execute({expected}), and its node is generated. A node of your own is "
            'described with "implementation": "node" and "node": {"class": ...}, and hosted as it is.'
        )
        return self._finding(NODE, node, message, hint)

    def _is_complete(self, cls: ast.ClassDef) -> bool:
        """Return whether all methods of a class are in this file."""
        seen = {cls.name}
        pending = [cls]
        while pending:
            current = pending.pop()
            open_ended = _binds(_statements(current.body), "execute") or current.keywords
            if open_ended or self._method(current, "__getattr__") or not _is_plain(current):
                return False
            for base in map(_unsubscripted, current.bases):
                above = self._class_named(base.id) if isinstance(base, ast.Name) else None
                if above is None and _last(base) not in _PLAIN_BASES:
                    return False
                if above is not None and above.name not in seen:
                    seen.add(above.name)
                    pending.append(above)
        return True

    def _method(self, cls: ast.ClassDef | None, name: str) -> ast.FunctionDef | ast.AsyncFunctionDef | None:
        pending = [cls] if cls is not None else []
        seen: set[str] = set()
        while pending:
            current = pending.pop(0)
            seen.add(current.name)
            for node in reversed(list(_statements(current.body))):
                if isinstance(node, _FUNCTIONS) and node.name == name:
                    return node
            above = [self._class_named(base.id) for base in current.bases if isinstance(base, ast.Name)]
            pending += [base for base in above if base is not None and base.name not in seen]
        return None

    # execute()

    def _execute(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[Finding]:
        if isinstance(node, ast.AsyncFunctionDef):
            yield self._signature(node, "execute() must not be async.")
            return
        yield from self._parameters(node)
        if not any(isinstance(part, (ast.Yield, ast.YieldFrom)) for part in ast.walk(node)):
            for returned in returns(node):
                yield from self._result(returned)

    def _parameters(self, node: ast.FunctionDef) -> Iterator[Finding]:
        inputs, arguments = self._component.inputs, node.args
        positional = [*arguments.posonlyargs, *arguments.args]
        bound = positional if _decorated(node, "staticmethod") else positional[1:]
        if bound is not positional:
            if not positional and arguments.vararg is None:
                yield self._signature(node, "execute() is a method: its first parameter has to be self.")
                return
            if positional and positional[0].arg in inputs:
                message = f"execute() is a method: its first parameter is self, not '{positional[0].arg}'."
                yield self._signature(positional[0], message)
                return
        named = [each.arg for each in (*bound, *arguments.kwonlyargs) if each not in arguments.posonlyargs]
        missing = [] if arguments.kwarg else [name for name in inputs if name not in named]
        extra = [name for name in required(node) if name not in inputs]
        places = {each.arg: each for each in (*positional, *arguments.kwonlyargs)}
        for name in extra:
            likely = _likely(name, missing) or (missing[0] if len(missing) == len(extra) == 1 else "")
            found = self._signature(places[name], f"execute() takes {names([name])}, which nobody gives it.")
            yield found._replace(hint=f"Did you mean '{likely}'? {found.hint}") if likely else found
        if missing:
            yield self._signature(node, f"execute() does not take {names(missing)}.")

    def _result(self, node: ast.Return) -> Iterator[Finding]:
        """Check a literal result; the keys each where it is written."""
        outputs = [Output(name) for name in self._component.outputs]
        value = node.value
        if not isinstance(value, ast.Dict) or not all(isinstance(key, ast.Constant) for key in value.keys):
            yield from super()._result(node)
            return
        written = [key.value for key in value.keys if isinstance(key, ast.Constant)]
        for rule, message, hint in check_keys(written, outputs):
            missing = [output.name for output in outputs if output.name not in written]
            wrong = [key for key in value.keys if isinstance(key, ast.Constant) and key.value not in self._keys()]
            likely = _likely(str(wrong[0].value), missing) if wrong else ""
            question = f"Did you mean '{likely}'? {hint}" if likely else hint
            yield self._finding(rule, wrong[0] if wrong else node, f"execute() {message} here.", question)

    def _keys(self) -> list[str]:
        return self._component.outputs


def check_needs(file: str, component: Component) -> list[Finding]:
    """Check what the node of a component needs, without what makes its results differ from run to run."""
    found = SourceRules(decode(Path(file).read_bytes()), component).check()
    return [finding for finding in found if finding.id not in component_repeatability.RULES]


def _statements(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Return the statements of a block and of the blocks in it, except those of functions and classes."""
    for node in body:
        yield node
        if not isinstance(node, (*_FUNCTIONS, ast.ClassDef, ast.expr)):
            yield from _statements(ast.iter_child_nodes(node))


def _binds(statements: Iterable[ast.AST], name: str) -> bool:
    """Return whether an import or an assignment binds a name, or may do so."""
    for node in statements:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            bound = {(alias.asname or alias.name).partition(".")[0] for alias in node.names}
            if bound & {name, "*"}:
                return True
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            stored = (
                each.id for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
            )
            if name in stored:
                return True
    return False


def _unsubscripted(node: ast.expr) -> ast.expr:
    return node.value if isinstance(node, ast.Subscript) else node


def _last(node: ast.expr) -> str:
    node = node.func if isinstance(node, ast.Call) else node
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def _first(node: ast.expr) -> str:
    while isinstance(node, ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def _decorated(node: ast.FunctionDef, name: str) -> bool:
    return any(_last(each) == name for each in node.decorator_list)


def _is_plain(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) -> bool:
    """Return whether no decorator may have changed what is defined."""
    return all(_last(each) in _PLAIN_DECORATORS for each in node.decorator_list)


def _likely(wrong: str, right: list[str]) -> str:
    """Return the name that was probably meant; empty if there is none."""
    same = [name for name in right if _folded(name) == _folded(wrong)]
    return next(iter(same or difflib.get_close_matches(wrong, right, n=1)), "")


def _folded(name: str) -> str:
    return name.replace("_", "").lower()


class NodeSource(Rules):
    """Checks the file of a node that is hosted as it is, or a module that such nodes import."""

    def __init__(self, source: str, class_name: str, arguments: dict[str, Any] | None) -> None:
        super().__init__(source, Component(class_name, [], []))
        self._arguments = arguments

    def found(self) -> list[dict[str, Any]]:
        """Return all findings, in the order of the file, each with whether it is uncertain."""
        try:
            self._tree = ast.parse(self._source)
            uses = node_rules.uses(self._tree, self._component.class_name)
            found = {(self._finding(*use), certain) for use, certain in uses}
            found.update(self._construction() if self._component.class_name else ())
        except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
            found = {(self._syntax(problem)._replace(hint=""), True)}
        ordered = sorted(found, key=lambda each: (each[0].line, each[0].column, each[0].id))
        return [{**finding._asdict(), "uncertain": not certain} for finding, certain in ordered]

    def _construction(self) -> Iterator[tuple[Finding, bool]]:
        for node, message, hint, certain in node_construction.problems(
            self._tree, self._component.class_name, self._arguments
        ):
            yield self._finding(node_construction.RULE, node, message, hint), certain


def _checked(source: dict[str, Any]) -> list[dict[str, Any]]:
    if "node" in source:
        return NodeSource(source["text"], source["node"], source.get("arguments")).found()
    described = Component(source["class"], source["inputs"], source["outputs"]) if "class" in source else None
    return [finding._asdict() for finding in SourceRules(source["text"], described).check()]


if __name__ == "__main__":
    print(json.dumps([_checked(source) for source in json.load(sys.stdin)["sources"]]))
