"""Parameters that a launch file in Python gives a node, as the elements ``param`` that XML would have."""

from __future__ import annotations

import ast
import json
from collections.abc import Callable, Iterator

from constants import Constants, Place, UnknownValueError
from source_modules import last_name

_CHANGES = (ast.Store, ast.Del)

Json = dict[str, object]


class LaunchParameters:
    """Reads the list of parameters of a node: dictionaries, and files.

    Args:
        constants: the constants of the file.
        place: the scope of the node.
        text: returns a text with substitutions, or None if it is not known.

    """

    def __init__(self, constants: Constants, place: Place, text: Callable[[ast.expr], str | None]) -> None:
        self._constants = constants
        self._place = place
        self._text = text

    def read(self, node: ast.expr | None) -> list[Json]:
        """Return an element for each parameter, and one for what is not known."""
        if node is None:
            return []
        node = self._definition(node)
        if not isinstance(node, (ast.List, ast.Tuple)):
            return [_element(node, {"name": None})]
        return [found for each in node.elts for found in self._entry(self._definition(each))]

    def _definition(self, node: ast.expr) -> ast.expr:
        if isinstance(node, ast.Name) and not self._is_changed(node.id):
            try:
                return self._constants.definition(node, self._place)[0]
            except UnknownValueError:
                return node
        return node

    def _is_changed(self, name: str) -> bool:
        """Return whether the file calls a method of a list or dictionary, or sets one of its elements."""
        return any(
            (isinstance(node, ast.Attribute) or (isinstance(node, ast.Subscript) and isinstance(node.ctx, _CHANGES)))
            and isinstance(node.value, ast.Name)
            and node.value.id == name
            for node in ast.walk(self._place.module.tree)
        )

    def _entry(self, node: ast.expr) -> Iterator[Json]:
        if isinstance(node, ast.Dict):
            yield from self._values(node, "")
            return
        attributes: Json = {}
        file: ast.expr | None = node
        if isinstance(node, ast.Call) and last_name(node.func) == "ParameterFile":
            keywords = {each.arg or "": each.value for each in node.keywords}
            file = node.args[0] if node.args else keywords.get("param_file")
            if len(node.args) > 1 or "allow_substs" in keywords:
                substitutes = keywords.get("allow_substs", node.args[-1] if node.args else None)
                known = isinstance(substitutes, ast.Constant) and isinstance(substitutes.value, bool)
                attributes["allow_substs"] = ast.unparse(substitutes) if known and substitutes else None
        name = self._text(file) if file is not None else None
        yield _element(node, {"name": None} if name is None else {**attributes, "from": name})

    def _values(self, node: ast.Dict, above: str) -> Iterator[Json]:
        for key, value in zip(node.keys, node.values, strict=True):
            name = self._text(key) if key is not None else None
            full = f"{above}{name}" if name is not None else None
            inner = self._definition(value)
            if isinstance(inner, ast.Dict) and full is not None:
                yield from self._values(inner, f"{full}.")
            else:
                yield _element(value, {"name": full, **self.value(value)})

    def value(self, node: ast.expr) -> Json:
        """Return a value: a known one in JSON, or a text with substitutions, whose type is inferred or stated."""
        node = self._definition(node)
        if isinstance(node, ast.Call) and last_name(node.func) == "ParameterValue":
            keywords = {each.arg or "": each.value for each in node.keywords}
            parts = [*node.args, *(keywords[key] for key in ("value", "value_type") if key in keywords)]
            found: Json = self.value(parts[0]) if parts else {}
            if len(parts) > 1:
                text = parts[0].value if isinstance(parts[0], ast.Constant) else found.get("value")
                found = {"value": None if text is None else str(text), "type": ast.unparse(parts[1])}
            return found
        try:
            known = self._constants.data(node, self._place)
            return {"json": json.dumps(known)} if known is not None else {}
        except UnknownValueError:
            return {"value": self._text(node)}


def _element(node: ast.AST, attributes: Json) -> Json:
    return {"kind": "param", "line": getattr(node, "lineno", 1), "attributes": attributes}
