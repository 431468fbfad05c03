"""Nodes of rclpy in the modules of a workspace: what they publish, subscribe to, and when they are called."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TypeGuard

from constants import Constants, Place, UnknownValueError
from made_nodes import Arguments, Made, NodeClass, argument, constructor_calls, constructors, parameters
from message_fields import MessageUse
from quality_of_service import QualityOfService
from ros_parameters import Given
from source_modules import FUNCTIONS, Function, Module, Modules, Question

_NODES = frozenset({"rclpy.node.Node", "rclpy.Node", "rclpy.lifecycle.Node", "rclpy.lifecycle.LifecycleNode"})
_MAKERS = frozenset({"create_publisher", "create_subscription", "create_timer"})
_LEFT_OUT = {
    "create_service": "a service",
    "create_client": "a client of a service",
    "create_rate": "a rate",
    "ActionServer": "an action",
    "ActionClient": "a client of an action",
    "TransformListener": "a listener to transforms",
    "TransformBroadcaster": "a broadcaster of transforms",
    "StaticTransformBroadcaster": "a broadcaster of transforms",
}
_SYNCHRONIZERS = ("TimeSynchronizer", "ApproximateTimeSynchronizer")
_CONDITIONS = (ast.If, ast.For, ast.While, ast.Try, ast.IfExp, ast.ListComp, ast.DictComp, ast.Lambda)

Json = dict[str, object]


class PythonNodes:
    """Reads the nodes of a workspace."""

    def __init__(self, modules: Modules) -> None:
        self._modules = modules
        self._constants = Constants(modules)
        self.questions: list[Question] = []

    def classes(self) -> list[NodeClass]:
        """Return the classes that are nodes, in the order of the files."""
        found = []
        for module in self._modules.all:
            for cls in module.classes.values():
                line, outside = self._line(module, cls)
                if any(base in _NODES for base in outside):
                    found.append(NodeClass(module, cls, line))
                elif self._makes_endpoints(cls):
                    bases = ", ".join(sorted(outside)) or "none"
                    text = f"Is {cls.name} a node? It makes publishers or subscriptions; its base is not here: {bases}."
                    self.questions.append(module.question(cls, text))
        return found

    def ask_for_others(self, nodes: list[NodeClass]) -> None:
        """Ask for what is made with node objects outside of the classes of nodes: once for each class and function."""
        known = {id(cls) for node in nodes for _, cls in node.line}
        for module in self._modules.all:
            if not any(full.startswith("rclpy") for full in module.imports.values()) or _is_test(module):
                continue
            for owner in [*module.classes.values(), *module.functions.values()]:
                call = next((each for each in ast.walk(owner) if _is_of_another(each)), None)
                if call is not None and id(owner) not in known:
                    text = f"Whose is what '{ast.unparse(call.func)}' makes? {owner.name} is no class of a node."
                    self.questions.append(module.question(call, text))

    def read(self, made: Made, given: Given | None = None) -> Json:
        """Return what is known of a node, and questions about what is not.

        Args:
            made: the node.
            given: what launch gives its parameters; nothing by default.

        """
        return _ClassReader(self._constants.of_node(parameters(made), given), made).read()

    def _line(self, module: Module, cls: ast.ClassDef) -> tuple[tuple[tuple[Module, ast.ClassDef], ...], set[str]]:
        """Return a class and its bases in the workspace, and the names of its other bases."""
        line: list[tuple[Module, ast.ClassDef]] = []
        outside: set[str] = set()
        pending = [(module, cls)]
        while pending:
            current = pending.pop(0)
            if current in line:
                continue
            line.append(current)
            for base in current[1].bases:
                inner = self._modules.class_named(current[0], base)
                if inner is not None:
                    pending.append(inner)
                else:
                    outside.add(current[0].full_name(base) or ast.unparse(base))
        return tuple(line), outside

    @staticmethod
    def _makes_endpoints(cls: ast.ClassDef) -> bool:
        return any(
            isinstance(each, ast.Call)
            and isinstance(each.func, ast.Attribute)
            and each.func.attr in _MAKERS
            and isinstance(each.func.value, ast.Name)
            and each.func.value.id == "self"
            for each in ast.walk(cls)
        )


def _is_of_another(node: ast.AST) -> TypeGuard[ast.Call]:
    """Return whether a call makes something for a node that is not `self`."""
    return (
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in _MAKERS
        and ast.unparse(node.func.value) != "self"
    )


def _is_test(module: Module) -> bool:
    folders, _, name = module.file.rpartition("/")
    return name.startswith("test_") or bool({"test", "tests"} & set(folders.split("/")))


class _ClassReader:
    def __init__(self, constants: Constants, made: Made) -> None:
        self._constants = constants
        self._qos = QualityOfService(constants)
        self._made = made
        self._node = node = made.node
        self._questions: list[Question] = []
        methods = [each for _, cls in node.line for each in cls.body if isinstance(each, FUNCTIONS)]
        self._use = MessageUse(methods)
        self._endpoints: list[Json] = []
        self._timers: list[Json] = []

    def read(self) -> Json:
        for module, cls in self._node.line:
            for method in cls.body:
                if isinstance(method, FUNCTIONS):
                    self._method(Place(module, self._node.line, method), method)
        arguments = Arguments(self._constants, self._made, self._ask).read()
        name, namespace = self._name("node_name", 0), self._name("namespace", None) or ""
        return {
            "file": self._node.module.file,
            "module": self._node.module.name,
            "class": self._node.definition.name,
            "line": self._node.definition.lineno,
            "name": name,
            "namespace": namespace,
            "arguments": arguments,
            "description": (ast.get_docstring(self._node.definition) or "").partition("\n")[0],
            "endpoints": self._endpoints,
            "timers": self._timers,
            "reads": sorted(self._constants.reads),
            "questions": [each.json for each in self._questions],
        }

    def _name(self, keyword: str, position: int | None) -> str | None:
        """Return an argument of the constructor of rclpy's node, which may come through those of bases."""
        call, place = self._made.call, self._made.place
        for module, method in constructors(self._node):
            inner = next(constructor_calls(method), None)
            if inner is not None:
                call, place = inner, Place(module, self._node.line, method)
        given = argument(call, keyword, position) if call is not None else None
        try:
            return self._constants.text(given, place) if given is not None else None
        except UnknownValueError as problem:
            if given is not None:
                self._ask(place.module, given, f"What is the node's {keyword.removeprefix('node_')}: {problem}?")
            return None

    # Calls

    def _method(self, place: Place, method: Function) -> None:
        targets = {
            each.value: each.targets[0]
            for each in ast.walk(method)
            if isinstance(each, ast.Assign) and len(each.targets) == 1
        }
        for call, is_conditional in _calls(method, False):
            name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
            full = place.module.full_name(call.func) or ""
            own = isinstance(call.func, ast.Attribute) and ast.unparse(call.func.value) == "self"
            if name in _MAKERS and not own:
                self._ask(place.module, call, f"Whose is what '{ast.unparse(call.func)}' makes?")
            elif name == "create_timer":
                self._timer(call, place)
            elif name in _MAKERS:
                self._endpoint(call, place, name, is_conditional, targets.get(call))
            elif full == "message_filters.Subscriber":
                self._filter(call, place, is_conditional)
            elif name in _SYNCHRONIZERS:
                whose = f"Which inputs of {self._node.definition.name} belong together, and within which tolerance?"
                self._ask(place.module, call, f"{whose} 'synchronized' and 'tolerance' of the component say it.")
            elif name in _LEFT_OUT and (own or not name.startswith("create_")):
                text = (
                    f"{self._node.definition.name} has {_LEFT_OUT[name]}, which a chain does not have. Does it matter?"
                )
                self._ask(place.module, call, text, is_beside_topics=True)

    def _endpoint(self, call: ast.Call, place: Place, maker: str, is_conditional: bool, target: ast.AST | None) -> None:
        publishes = maker == "create_publisher"
        kind = "publisher" if publishes else "subscription"
        qos = argument(call, "qos_profile", 2 if publishes else 3)
        topic = argument(call, "topic", 1)
        callback = None if publishes else argument(call, "callback", 2)
        if publishes:
            fields = self._use.written(target) if target is not None else None
        else:
            fields = self._use.read(callback) if callback is not None else None
        self._add(call, place, kind, (argument(call, "msg_type", 0), topic, qos), fields)
        if is_conditional:
            self._ask(place.module, call, f"Is this {kind} made? That is decided when the node runs.")

    def _filter(self, call: ast.Call, place: Place, is_conditional: bool) -> None:
        qos = next((each.value for each in call.keywords if each.arg == "qos_profile"), None) or ast.Constant(10)
        parts = (argument(call, "msg_type", 1), argument(call, "topic", 2), qos)
        self._add(call, place, "subscription", parts, None)
        if is_conditional:
            self._ask(place.module, call, "Is this subscription made? That is decided when the node runs.")

    def _add(
        self,
        call: ast.Call,
        place: Place,
        kind: str,
        parts: tuple[ast.expr | None, ast.expr | None, ast.expr | None],
        fields: list[str] | None,
    ) -> None:
        found: Json = {"kind": kind, "file": place.module.file, "line": call.lineno, "fields": fields}
        try:
            found["type"] = self._type(parts[0], place)
        except UnknownValueError as problem:
            self._ask(place.module, call, f"What is the type of this {kind}: {problem}?")
            return
        try:
            found["topic"] = self._constants.text(_given(parts[1]), place)
        except UnknownValueError as problem:
            self._ask(place.module, call, f"What is the topic of this {kind} of {found['type']}: {problem}?")
            return
        try:
            found["qos"] = self._qos.read(_given(parts[2]), place)
        except UnknownValueError as problem:
            text = f"What is the quality of service of '{found['topic']}' here: {problem}?"
            self._ask(place.module, call, text)
            found["qos"] = None
        self._endpoints.append(found)

    def _type(self, node: ast.expr | None, place: Place) -> str:
        full = place.module.full_name(_given(node)) or ""
        parts = full.split(".")
        if len(parts) == 3 and parts[1] == "msg":
            return "/".join(parts)
        if isinstance(node, ast.Name):
            inner, there = self._constants.definition(node, place)
            if inner is not node:
                return self._type(inner, there)
        raise UnknownValueError(f"it is '{ast.unparse(_given(node))[:60]}'")

    def _timer(self, call: ast.Call, place: Place) -> None:
        try:
            period = self._constants.number(_given(argument(call, "timer_period_sec", 0)), place)
            if period <= 0:
                raise UnknownValueError(f"it is {period}")
            self._timers.append({"period": period, "file": place.module.file, "line": call.lineno})
        except UnknownValueError as problem:
            self._ask(place.module, call, f"What is the period of this timer: {problem}?")

    def _ask(self, module: Module, node: ast.AST, text: str, *, is_beside_topics: bool = False) -> None:
        question = module.question(node, text)._replace(is_beside_topics=is_beside_topics)
        if question not in self._questions:
            self._questions.append(question)


def _given(node: ast.expr | None) -> ast.expr:
    if node is None:
        raise UnknownValueError("it is not given")
    return node


def _calls(node: ast.AST, is_conditional: bool) -> Iterator[tuple[ast.Call, bool]]:
    """Return the calls in a block in their order, and whether they are made depends on what runs."""
    for child in ast.iter_child_nodes(node):
        inner = is_conditional or isinstance(child, (*_CONDITIONS, *FUNCTIONS))
        if isinstance(child, ast.Call):
            yield child, is_conditional
        yield from _calls(child, inner)
