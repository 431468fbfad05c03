"""Texts in launch files in Python, with the substitutions that the same texts in XML would have.

Substitutions are ``$(var NAME)``, ``$(var NAME DEFAULT)``, ``$(find-pkg-share PACKAGE)``, and those that decide and
calculate, such as ``$(and "VALUE" "VALUE")``. What is not known is None.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable

from constants import Constants, Place, UnknownValueError
from source_modules import last_name

_DECIDING = {
    "AndSubstitution": "and",
    "OrSubstitution": "or",
    "NotSubstitution": "not",
    "AnySubstitution": "any",
    "AllSubstitution": "all",
    "EqualsSubstitution": "equals",
    "NotEqualsSubstitution": "not-equals",
    "IfElseSubstitution": "if",
    "PythonExpression": "eval",
}
_SUBSTITUTED = frozenset({"text", "package", "variable_name"})
_SHARES = frozenset({"get_package_share_directory", "FindPackageShare", "get_package_share_path"})


class LaunchTexts:
    """Reads texts at one place of a file."""

    def __init__(self, constants: Constants, place: Place) -> None:
        self._constants = constants
        self._place = place

    def text(self, node: ast.expr, depth: int = 0) -> str | None:
        """Return a text with substitutions; None if it is not known."""
        if depth > 20:
            return None
        if isinstance(node, (ast.List, ast.Tuple)):
            return joined((self.text(each, depth + 1) for each in node.elts), "")
        if isinstance(node, ast.Call):
            return self._substitution(node, depth)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return joined((self.text(each, depth + 1) for each in (node.left, node.right)), "")
        if isinstance(node, ast.JoinedStr):
            return joined((self.text(each, depth + 1) for each in node.values), "")
        if isinstance(node, ast.FormattedValue):
            is_plain = node.conversion == -1 and node.format_spec is None
            return self.text(node.value, depth + 1) if is_plain else None
        try:
            value = self._constants.value(node, self._place)
            return value if isinstance(value, str) else None
        except UnknownValueError:
            pass
        if isinstance(node, ast.Name):
            try:
                return self.text(self._constants.definition(node, self._place)[0], depth + 1)
            except UnknownValueError:
                return None
        return None

    def _substitution(self, node: ast.Call, depth: int) -> str | None:
        name = last_name(node.func)
        if name == "perform" and isinstance(node.func, ast.Attribute):
            return self.text(node.func.value, depth + 1)
        if name in _DECIDING:
            values = [*node.args, *(each.value for each in node.keywords)]
            texts = [_quoted(self.text(each, depth + 1)) for each in values]
            return joined([f"$({_DECIDING[name]}", *texts], " ", ")")
        arguments = [*node.args, *(each.value for each in node.keywords if each.arg in _SUBSTITUTED)]
        if name == "join" or name == "PathJoinSubstitution":
            parts = arguments
            if name == "PathJoinSubstitution" and arguments and isinstance(arguments[0], (ast.List, ast.Tuple)):
                parts = list(arguments[0].elts)
            return joined((self.text(each, depth + 1) for each in parts), "/")
        first = self.text(arguments[0], depth + 1) if arguments else None
        if first is None:
            return None
        if name == "LaunchConfiguration":
            return self._configuration(first, node, depth)
        if name in _SHARES:
            return f"$(find-pkg-share {first})"
        return first if name in ("TextSubstitution", "str") else None

    def _configuration(self, name: str, node: ast.Call, depth: int) -> str | None:
        default = next((each.value for each in node.keywords if each.arg == "default"), None)
        if default is None or (isinstance(default, ast.Constant) and default.value is None):
            return f"$(var {name})"
        text = self.text(default, depth + 1)
        if text is None or "'" in text or not _is_balanced(text):
            return f"$(var {name} $(unknown))"
        return f"$(var {name} '{text}')" if not text or text != text.strip() else f"$(var {name} {text})"


def _is_balanced(text: str) -> bool:
    """Return whether each parenthesis of a text is closed."""
    depth = 0
    for each in text:
        depth += (each == "(") - (each == ")")
        if depth < 0:
            return False
    return depth == 0


def _quoted(text: str | None) -> str | None:
    """Return a text as a word of a substitution."""
    return None if text is None else '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def joined(parts: Iterable[str | None], separator: str, end: str = "") -> str | None:
    """Return texts as one; None if one of them is not known."""
    texts = list(parts)
    known = [text for text in texts if text is not None]
    return separator.join(known) + end if len(known) == len(texts) else None
