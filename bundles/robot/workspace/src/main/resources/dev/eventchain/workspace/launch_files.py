"""Launch files in Python, as far as they only declare: as the elements that the same file in XML would have.

An element is an object with ``kind``, ``line``, and as the kind needs ``attributes``, ``remaps`` and ``children``.
Texts have the substitutions of XML (see launch_texts). What is not known is None.
"""

from __future__ import annotations

import ast
import contextlib
from collections.abc import Iterator

from constants import Constants, Place, UnknownValueError
from launch_parameters import LaunchParameters
from launch_texts import LaunchTexts, joined
from source_modules import FUNCTIONS, Function, Module, last_name

Json = dict[str, object]

_IGNORED = frozenset(
    {"LogInfo", "SetEnvironmentVariable", "AppendEnvironmentVariable", "UnsetEnvironmentVariable", "Shutdown"}
)
_DECISIONS = (ast.If, ast.For, ast.While, ast.With, ast.Try)
_NODES = frozenset({"Node", "LifecycleNode"})
_TIMERS = frozenset({"TimerAction", "RosTimer"})
_CONDITIONS = {"IfCondition": "if", "UnlessCondition": "unless"}
_COMPARISONS = {"LaunchConfigurationEquals": "equals", "LaunchConfigurationNotEquals": "differs"}
_EVENTS = {"OnProcessStart": "on_start", "OnProcessExit": "on_exit", "OnExecutionComplete": "on_completion"}
_NAMED = {"package": "pkg", "executable": "exec", "plugin": "plugin", "name": "name", "namespace": "namespace"}
_ARGUMENTS = {"arguments": "args", "ros_arguments": "ros_args"}
_MUTATORS = frozenset({"append", "clear", "extend", "insert", "pop", "popitem", "remove", "setdefault", "update"})


class LaunchFile:
    """Reads the description that a launch file returns."""

    def __init__(self, module: Module, constants: Constants) -> None:
        self._module = module
        self._constants = constants
        self._place = Place(module)
        self._followed: list[Function] = []  # functions of OpaqueFunction that are being read
        self._lists: list[str] = []  # names of lists that are being read

    def read(self) -> list[Json]:
        """Return the elements of the launch description."""
        function = self._module.functions.get("generate_launch_description")
        if not isinstance(function, FUNCTIONS):
            return [_unknown(1, "it has no generate_launch_description()")]
        self._place = Place(self._module, (), function)
        found: list[Json] = []
        for node in ast.walk(function):
            if isinstance(node, ast.Call) and last_name(node.func) == "LaunchDescription":
                keyword = [each.value for each in node.keywords if each.arg == "initial_entities"]
                for given in node.args[:1] or keyword:
                    found += self._list(given, node)
        for statement in function.body:
            found += self._statement(statement)
        return found

    def _statement(self, node: ast.stmt) -> Iterator[Json]:
        """Return what a statement adds to the description: ``description.add_action(node)``."""
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            if last_name(node.value.func) in ("add_action", "add_entity") and len(node.value.args) == 1:
                yield self._element(node.value.args[0])
        elif isinstance(node, _DECISIONS) and any(isinstance(each, ast.Call) for each in ast.walk(node)):
            yield _unknown(node.lineno, "what it launches is decided when it runs")

    def _list(self, node: ast.expr, owner: ast.AST) -> list[Json]:
        if isinstance(node, ast.Name):
            return self._named_list(node, owner)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return [*self._list(node.left, owner), *self._list(node.right, owner)]
        if isinstance(node, (ast.List, ast.Tuple)):
            return [self._element(each) for each in node.elts]
        return [_unknown(owner, f"it launches '{ast.unparse(node)[:60]}'")]

    def _named_list(self, node: ast.Name, owner: ast.AST) -> list[Json]:
        """Return what a list has that a name is given, and what is added to it then."""
        if node.id in self._lists:
            return [_unknown(owner, f"'{node.id}' is a part of itself")]
        outside = self._place
        self._lists.append(node.id)
        try:
            inner, self._place = self._constants.definition(node, outside)
            found = self._list(inner, owner)
            self._place = outside
            return [*found, *self._added(node.id)]
        except UnknownValueError as problem:
            return [_unknown(owner, str(problem))]
        finally:
            self._lists.pop()

    def _added(self, name: str) -> Iterator[Json]:
        """Return what the statements of a function add to a list."""
        for statement in self._place.function.body if self._place.function else ():
            call = statement.value if isinstance(statement, ast.Expr) else None
            method = call.func if isinstance(call, ast.Call) else None
            if isinstance(call, ast.Call) and isinstance(method, ast.Attribute) and _is_named(method.value, name):
                if method.attr == "append" and len(call.args) == 1:
                    yield self._element(call.args[0])
                elif method.attr == "extend" and len(call.args) == 1:
                    yield from self._list(call.args[0], call)
                else:
                    yield _unknown(call, f"'{name}.{method.attr}' changes it when it runs")

    def _element(self, node: ast.expr, depth: int = 0) -> Json:
        if isinstance(node, ast.Name) and depth < 20:
            try:
                return self._element(self._constants.definition(node, self._place)[0], depth + 1)
            except UnknownValueError as problem:
                return _unknown(node, str(problem))
        if not isinstance(node, ast.Call):
            return _unknown(node, f"it launches '{ast.unparse(node)[:60]}'")
        name = last_name(node.func)
        keywords = {each.arg or "": each.value for each in node.keywords}
        if "" in keywords:
            return _unknown(node, f"what '**' gives '{name}' is not read")
        found = self._call(name, node, keywords)
        if "condition" in keywords and found["kind"] != "ignored":
            found["condition"] = self._condition(keywords["condition"])
        return found

    def _condition(self, node: ast.expr) -> dict[str, str | None]:
        """Return a condition as attributes; ``if`` is None if it is not known."""
        node = self._definition(node)
        unknown: dict[str, str | None] = {"if": None}
        if not isinstance(node, ast.Call):
            return unknown
        values = [*node.args, *(each.value for each in node.keywords)]
        name = last_name(node.func)
        if name in _CONDITIONS and len(values) == 1:
            return {_CONDITIONS[name]: self._text(values[0])}
        if name in _COMPARISONS and len(values) == 2:
            variable = self._text(values[0])
            return {_COMPARISONS[name]: f"$(var {variable})" if variable else None, "to": self._text(values[1])}
        return unknown

    def _call(self, name: str, node: ast.Call, keywords: dict[str, ast.expr]) -> Json:
        if name in _NODES or name == "ComposableNode":
            attributes = {ours: self._text(keywords[theirs]) for theirs, ours in _NAMED.items() if theirs in keywords}
            for theirs, ours in _ARGUMENTS.items():
                if theirs in keywords:
                    attributes[ours] = self._words(keywords[theirs])
            remaps = self._remaps(keywords.get("remappings"), node)
            values = self._parameters().read(keywords.get("parameters"))
            kind = "node" if name in _NODES else "composable_node"
            element: Json = {"kind": kind, "line": node.lineno, "attributes": attributes, "remaps": remaps}
            return {**element, "parameters": values}
        if name in ("ComposableNodeContainer", "LoadComposableNodes"):
            given = keywords.get("composable_node_descriptions", ast.List([]))
            nodes = [] if isinstance(given, ast.Constant) and given.value is None else self._list(given, node)
            attributes = {ours: self._text(keywords[theirs]) for theirs, ours in _NAMED.items() if theirs in keywords}
            kind = "node_container" if name == "ComposableNodeContainer" else "load_composable_node"
            return {"kind": kind, "line": node.lineno, "attributes": attributes, "children": nodes}
        if name == "RegisterEventHandler" and (node.args or keywords):
            return self._event(node.args[0] if node.args else next(iter(keywords.values())), node)
        if name == "EmitEvent" and "Shutdown" in {last_name(each.func) for each in _calls(node)}:
            return {"kind": "ignored", "line": node.lineno}
        if name == "IncludeLaunchDescription" and (node.args or keywords):
            source = node.args[0] if node.args else next(iter(keywords.values()))
            inner = source.args[0] if isinstance(source, ast.Call) and source.args else source
            arguments = self._pairs(keywords.get("launch_arguments"))
            attributes = {"file": self._text(inner)}
            return {"kind": "include", "line": node.lineno, "attributes": attributes, "arguments": arguments}
        if name in ("GroupAction", *_TIMERS):
            actions = keywords.get("actions") or (node.args[0] if node.args else ast.List([]))
            children = [*self._kept(keywords.get("launch_configurations"), node), *self._list(actions, node)]
            kind = "timer" if name in _TIMERS else "group"
            return {"kind": kind, "line": node.lineno, "attributes": self._scoped(keywords), "children": children}
        if name == "OpaqueFunction":
            return self._function(node, keywords)
        if name in ("PushRosNamespace", "PushROSNamespace"):
            given = keywords.get("namespace") or (node.args[0] if node.args else ast.Constant(None))
            attributes = {"namespace": self._text(given)}
            return {"kind": "push_ros_namespace", "line": node.lineno, "attributes": attributes}
        if name == "SetRemap":
            parts = [*node.args, *(keywords[key] for key in ("src", "dst") if key in keywords)]
            return {"kind": "set_remap", "line": node.lineno, "remaps": [[self._text(each) for each in parts[:2]]]}
        if name == "SetUseSimTime":
            value = self._parameters().value(node.args[0]) if node.args else {}
            return {"kind": "set_parameter", "line": node.lineno, "attributes": {"name": "use_sim_time", **value}}
        if name == "SetParameter":
            parts = [*node.args, *(keywords[key] for key in ("name", "value") if key in keywords)]
            attributes = {"name": self._text(parts[0]) if parts else None}
            value = self._parameters().value(parts[1]) if len(parts) == 2 else {}
            return {"kind": "set_parameter", "line": node.lineno, "attributes": {**attributes, **value}}
        if name == "SetParametersFromFile":
            named = keywords.get("filename") or (node.args[0] if node.args else ast.Constant(None))
            attributes = {"filename": self._text(named)}
            return {"kind": "set_parameters_from_file", "line": node.lineno, "attributes": attributes}
        if name == "DeclareLaunchArgument":
            argument = keywords.get("name") or (node.args[0] if node.args else ast.Constant(None))
            default = keywords.get("default_value")
            attributes = {"name": self._text(argument), "default": self._text(default) if default else None}
            return {"kind": "arg", "line": node.lineno, "attributes": attributes}
        if name == "SetLaunchConfiguration":
            parts = [*node.args, *(keywords[key] for key in ("name", "value") if key in keywords)]
            attributes = dict(zip(("name", "value"), map(self._text, parts), strict=False))
            return {"kind": "let", "line": node.lineno, "attributes": attributes}
        if name == "UnsetLaunchConfiguration":
            given = keywords.get("name") or (node.args[0] if node.args else ast.Constant(None))
            return {"kind": "unset", "line": node.lineno, "attributes": {"name": self._text(given)}}
        if name in _IGNORED:
            return {"kind": "ignored", "line": node.lineno}
        return _unknown(node, f"what '{name}' launches is not read")

    def _event(self, given: ast.expr, node: ast.Call) -> Json:
        """Return what an event handler launches: when a process starts, or ends. On a shutdown nothing counts."""
        handler = self._definition(given)
        name = last_name(handler.func) if isinstance(handler, ast.Call) else ""
        if not isinstance(handler, ast.Call) or name not in (*_EVENTS, "OnShutdown"):
            return _unknown(node, "what 'RegisterEventHandler' launches is not read")
        keywords = {each.arg or "": each.value for each in handler.keywords}
        actions = self._definition(keywords.get(_EVENTS.get(name, ""), ast.List([])))
        is_list = isinstance(actions, (ast.List, ast.Tuple, ast.BinOp))
        children = self._list(actions, node) if is_list else [self._element(actions)]
        launching = [each for each in children if each["kind"] != "ignored"]
        if name == "OnShutdown" or not launching:
            return {"kind": "ignored", "line": node.lineno}
        target = keywords.get("target_action") or (handler.args[0] if handler.args else None)
        process = self._definition(target) if target is not None else None
        line = str(process.lineno) if isinstance(process, ast.Call) else ""
        attributes = {"event": "start" if name == "OnProcessStart" else "end", "target": line}
        return {"kind": "event_handler", "line": node.lineno, "attributes": attributes, "children": launching}

    def _function(self, node: ast.Call, keywords: dict[str, ast.expr]) -> Json:
        """Return what a function launches that only returns a list; another one decides when it runs."""
        named = keywords.get("function") or (node.args[0] if node.args else None)
        function = self._module.functions.get(named.id) if isinstance(named, ast.Name) else None
        if not isinstance(function, ast.FunctionDef) or set(keywords) - {"function", "condition"}:
            return _unknown(node, "what 'OpaqueFunction' launches is not read")
        result = returned(function)
        if result is None or function in self._followed:
            return _unknown(node, f"'{function.name}' decides it when it runs")
        outside = self._place
        self._place = Place(self._module, (), function)
        self._followed.append(function)
        children = self._list(result, node)
        self._followed.pop()
        self._place = outside
        return {"kind": "group", "line": node.lineno, "attributes": {"scoped": "false"}, "children": children}

    def _kept(self, node: ast.expr | None, owner: ast.AST) -> Iterator[Json]:
        """Return what sets the configurations that a group is given."""
        for name, value in self._pairs(node):
            if name is None:
                yield _unknown(owner, "the configurations of this group are not known")
            else:
                line = getattr(owner, "lineno", 1)
                yield {"kind": "let", "line": line, "attributes": {"name": name, "value": value}}

    def _parameters(self) -> LaunchParameters:
        return LaunchParameters(self._constants, self._place, self._text)

    def _scoped(self, keywords: dict[str, ast.expr]) -> dict[str, str | None]:
        """Return whether a group keeps what it changes, and gets what is changed around it."""
        found: dict[str, str | None] = {}
        for name in ("scoped", "forwarding"):
            given = keywords.get(name)
            if given is not None:
                found[name] = str(given.value).lower() if isinstance(given, ast.Constant) else None
        return found

    def _words(self, node: ast.expr) -> str | None:
        """Return a list of texts as one, with spaces."""
        node = self._collection(node)
        if isinstance(node, (ast.List, ast.Tuple)):
            return joined((self._text(each) for each in node.elts), " ")
        return None if isinstance(node, ast.Name) else self._text(node)

    def _remaps(self, node: ast.expr | None, owner: ast.AST) -> list[list[str | None]]:
        if node is None:
            return []
        return [[before, after] for before, after in self._pairs(node)]

    def _pairs(self, node: ast.expr | None) -> list[tuple[str | None, str | None]]:
        """Return pairs of texts: a list of tuples, or the items of a dict; an unknown list is one unknown pair."""
        if node is None:
            return []
        node = self._collection(node)
        if isinstance(node, ast.Call) and last_name(node.func) == "items" and isinstance(node.func, ast.Attribute):
            node = self._collection(node.func.value)
        if isinstance(node, ast.Dict) and all(key is not None for key in node.keys):
            items = zip(node.keys, node.values, strict=True)
            return [(self._text(key), self._text(value)) for key, value in items if key]
        if isinstance(node, (ast.List, ast.Tuple)) and all(_is_pair(each) for each in node.elts):
            pairs = [each.elts for each in node.elts if isinstance(each, (ast.List, ast.Tuple))]
            return [(self._text(first), self._text(second)) for first, second in pairs]
        return [(None, None)]

    def _definition(self, node: ast.expr) -> ast.expr:
        """Return what a name is given, as far as it is known."""
        if isinstance(node, ast.Name):
            with contextlib.suppress(UnknownValueError):
                return self._constants.definition(node, self._place)[0]
        return node

    def _collection(self, node: ast.expr) -> ast.expr:
        """Return the list or dictionary that a name is given, unless the file changes it later."""
        if isinstance(node, ast.Name) and any(_changes(each, node.id) for each in ast.walk(self._module.tree)):
            return node
        return self._definition(node)

    def _text(self, node: ast.expr) -> str | None:
        """Return a text with substitutions; None if it is not known."""
        return LaunchTexts(self._constants, self._place).text(node)


def returned(function: ast.FunctionDef) -> ast.expr | None:
    """Return what a function returns that only gives names to values and returns, whatever it is called with.

    It may ask its context for the values of substitutions, and for nothing else.
    """
    *before, last = function.body
    given = {each.arg for each in (*function.args.args, *function.args.kwonlyargs)}
    asked: set[ast.AST] = set()
    for node in ast.walk(function):
        if isinstance(node, ast.Call) and last_name(node.func) == "perform":
            asked.update(node.args)
    for node in ast.walk(function):
        if isinstance(node, ast.Name) and node.id in given and node not in asked:
            return None
    for statement in before:
        is_text = isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)
        targets = statement.targets if isinstance(statement, ast.Assign) else []
        if not is_text and not (targets and all(isinstance(each, ast.Name) for each in targets)):
            return None
    return last.value if isinstance(last, ast.Return) else None


def _is_named(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name


def _changes(node: ast.AST, name: str) -> bool:
    """Return whether an expression changes what is in the list or dictionary of a name."""
    if isinstance(node, ast.Subscript):
        return isinstance(node.ctx, (ast.Store, ast.Del)) and _is_named(node.value, name)
    return isinstance(node, ast.Attribute) and node.attr in _MUTATORS and _is_named(node.value, name)


def _is_pair(node: ast.expr) -> bool:
    return isinstance(node, (ast.List, ast.Tuple)) and len(node.elts) == 2


def _calls(node: ast.AST) -> Iterator[ast.Call]:
    return (each for each in ast.walk(node) if isinstance(each, ast.Call))


def _unknown(place: ast.AST | int, reason: str) -> Json:
    line = place if isinstance(place, int) else getattr(place, "lineno", 1)
    return {"kind": "unknown", "line": line, "text": reason}
