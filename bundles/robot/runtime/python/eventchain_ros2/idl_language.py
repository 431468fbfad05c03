"""Message definitions in OMG IDL 4.2, as far as ROS 2 uses it (design.ros2.org, "IDL Interface Definition").

A file `<package>/msg/<Name>.idl` holds the structure `<package>::msg::<Name>`, besides it type definitions for arrays
and sequences, and the constants of the module `<Name>_Constants`. What else IDL has is refused. Annotations say nothing
about the bytes, so that all are skipped but `@default`; those that would change the bytes are refused.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple, NoReturn

from eventchain_ros2.definitions import (
    PRIMITIVES,
    Constant,
    Definition,
    Field,
    FieldType,
    MessageDefinitionError,
    Value,
    check_name,
    default_value,
    full_name,
    literal,
)

PLACEHOLDER = "structure_needs_at_least_one_member"
"""The only member of a structure that stands for a message without fields (rosidl)."""

_TOKEN = re.compile(
    r"(?P<space>\s+|//[^\n]*|/\*.*?\*/)"
    r"|(?P<include>\#[ \t]*include[^\n]*)"
    r'|(?P<text>"(?:[^"\\\n]|\\.)*")'
    r"|(?P<number>\.?\d(?:[eE][+-]|[\w.])*)"
    r"|(?P<word>[A-Za-z_]\w*)"
    r"|(?P<sign>::|[{}()<>\[\];:,=@+-])",
    re.DOTALL | re.ASCII,
)
_OCTAL = re.compile(r"0[0-7]+")
_LISTED = re.compile(r'"[(\[](.*?),?[)\]]"', re.DOTALL)
"""How rosidl writes the values of an array: as a text, `"(1, 2)"`."""
_ESCAPES = {"n": "\n", "t": "\t", "v": "\v", "b": "\b", "r": "\r", "f": "\f", "a": "\a"}
_ESCAPES.update({character: character for character in "\\?'\""})
_PRIMITIVES = {"boolean": "bool", "octet": "byte", "float": "float32", "double": "float64"}
_PRIMITIVES.update({"short": "int16", "long": "int32", "long long": "int64", "unsigned short": "uint16"})
_PRIMITIVES.update({"unsigned long": "uint32", "unsigned long long": "uint64"})
_PRIMITIVES.update({name: name for name in PRIMITIVES if "int" in name})
_PARTS = {part for name in _PRIMITIVES for part in name.split()}
_NO_TYPES = {"any", "char", "enum", "fixed", "map", "native", "object", "struct", "union", "wchar", "wstring"}
_CHANGE_BYTES = {"bit_bound", "external", "mutable", "optional"}


class _Token(NamedTuple):
    kind: str
    text: str
    line: int


def parse(name: str, text: str, file: str) -> Definition:
    """Read the definition of one message type.

    Raises:
        MessageDefinitionError: the text is no IDL, or has what the definition of a message does not have.

    """
    return _Parser(name, text, file).definition()


class _Parser:
    def __init__(self, name: str, text: str, file: str) -> None:
        self._package, _, self._short_name = name.split("/")
        self._definition = Definition(name, file, [], [])
        self._aliases: dict[str, FieldType] = {}
        self._is_defined = False
        self._line = 1
        self._tokens = list(self._split(text))
        self._position = 0

    def _split(self, text: str) -> Iterator[_Token]:
        position = 0
        while position < len(text):
            match = _TOKEN.match(text, position)
            if match is None:
                self._refuse(f"{text[position]!r} is not allowed here")
            kind = match.lastgroup or ""
            if kind not in ("space", "include"):
                yield _Token(kind, match[0], self._line)
            self._line += match[0].count("\n")
            position = match.end()
        yield _Token("end", "the end of the file", self._line)

    def definition(self) -> Definition:
        while self._next.kind != "end":
            self._item(())
        if not self._is_defined:
            self._line = 0
            self._refuse(f"there is no structure {self._package}::msg::{self._short_name}")
        fields = self._definition.fields
        if [field.name for field in fields] == [PLACEHOLDER]:
            fields.clear()
        return self._definition

    @property
    def _next(self) -> _Token:
        return self._tokens[self._position]

    def _take(self, *wanted: str) -> str:
        """The next token, which has to be one of these kinds or texts."""
        token = self._next
        self._line = token.line
        if token.kind not in wanted and token.text not in wanted:
            self._refuse(f"here has to be {' or '.join(wanted)}, not {token.text}")
        self._position += 1
        return token.text

    def _is_next(self, text: str) -> bool:
        """Take the next token if it is this one; whether it is."""
        found = self._next.text == text
        if found:
            self._take(text)
        return found

    def _refuse(self, problem: str) -> NoReturn:
        raise MessageDefinitionError(f"{self._definition.name}: {problem}", self._definition.file, self._line)

    def _item(self, scope: tuple[str, ...]) -> None:
        self._annotations()
        word = self._take("word")
        if word == "module":
            self._module(scope)
        elif word == "typedef" and scope in ((self._package,), (self._package, "msg")):
            field_type = self._type()
            for name, array in self._declarators(field_type):
                self._aliases[name] = array
        elif word == "const" and scope == (self._package, "msg", f"{self._short_name}_Constants"):
            self._constant()
        elif word == "struct" and scope == (self._package, "msg"):
            self._structure()
        else:
            place = "::".join(scope) or "outside of modules"
            self._refuse(f"'{word}' of IDL is not part of a message definition ({place})")
        self._take(";")

    def _module(self, scope: tuple[str, ...]) -> None:
        inner = (*scope, self._take("word"))
        known = (self._package, "msg", f"{self._short_name}_Constants")
        if inner != known[: len(inner)]:
            self._refuse(f"the module {'::'.join(inner)} is not one of {'::'.join(known)}")
        self._take("{")
        while not self._is_next("}"):
            self._item(inner)

    def _annotations(self) -> str | None:
        """Skip annotations; the value of `@default`."""
        default = None
        while self._is_next("@"):
            name = self._take("word")
            if name in _CHANGE_BYTES or (
                name == "extensibility" and self._tokens[self._position + 1].text == "MUTABLE"
            ):
                self._refuse(f"@{name} is not part of a message definition")
            if name == "default":
                default = self._default()
            elif self._is_next("("):
                self._skip_arguments()
        return default

    def _default(self) -> str:
        self._take("(")
        if self._next.text == "value" and self._tokens[self._position + 1].text == "=":
            self._position += 2
        value = self._value()
        self._take(")")
        return value

    def _skip_arguments(self) -> None:
        depth = 1
        while depth:
            if self._next.kind == "end":
                self._take(")")
            depth += {"(": 1, ")": -1}.get(self._next.text, 0) if self._next.kind == "sign" else 0
            self._position += 1

    def _value(self) -> str:
        """A literal, as the message language writes it; texts in quotes."""
        if self._next.kind == "text":
            parts = []
            while self._next.kind == "text":
                parts.append(self._unescaped(self._take("text")[1:-1]))
            text = "".join(parts).replace('"', '\\"')
            return f'"{text}"'
        sign = self._take("+", "-") if self._next.text in ("+", "-") else ""
        if sign or self._next.kind == "number":
            number = self._take("number")
            if _OCTAL.fullmatch(number):
                number = f"0o{number[1:]}"
            return sign.replace("+", "") + number
        return self._take("TRUE", "FALSE").lower()

    def _unescaped(self, text: str) -> str:
        def character(match: re.Match[str]) -> str:
            if match[1] not in _ESCAPES:
                self._refuse(f"the escape sequence {match[0]} is not read")
            return _ESCAPES[match[1]]

        return re.sub(r"\\(.)", character, text, flags=re.DOTALL)

    def _constant(self) -> None:
        field_type = self._type()
        name = self._take("word")
        self._take("=")
        if field_type.kind != "scalar" or field_type.base not in PRIMITIVES:
            self._refuse("a constant is a number, a text, TRUE or FALSE")
        value = self._value()
        self._check(name)
        self._definition.constants.append(Constant(name, field_type.base, self._literal(field_type, value)))

    def _literal(self, field_type: FieldType, text: str) -> Value:
        try:
            return literal(field_type.base, text)
        except ValueError as problem:
            self._refuse(str(problem))

    def _check(self, name: str) -> None:
        try:
            check_name(self._definition, name)
        except ValueError as problem:
            self._refuse(str(problem))

    def _structure(self) -> None:
        name = self._take("word")
        if name != self._short_name or self._is_defined:
            self._refuse(f"the structure {name} needs its own file, {name}.idl")
        self._is_defined = True
        self._take("{")
        while not self._is_next("}"):
            self._member()

    def _member(self) -> None:
        default = self._annotations()
        field_type = self._type()
        for name, declared in self._declarators(field_type):
            self._check(name)
            self._definition.fields.append(Field(name, declared, self._default_of(declared, default)))
        self._take(";")

    def _default_of(self, field_type: FieldType, text: str | None) -> Value | list[Value] | None:
        if text is None:
            return None
        listed = _LISTED.fullmatch(text) if field_type.kind != "scalar" else None
        if listed:
            text = "[" + listed[1].replace('\\"', '"') + "]"
        try:
            return default_value(field_type, text)
        except ValueError as problem:
            self._refuse(str(problem))

    def _declarators(self, field_type: FieldType) -> list[tuple[str, FieldType]]:
        declared = [self._declarator(field_type)]
        while self._is_next(","):
            declared.append(self._declarator(field_type))
        return declared

    def _declarator(self, field_type: FieldType) -> tuple[str, FieldType]:
        name = self._take("word")
        while self._is_next("["):
            field_type = self._collection(field_type, "array", self._size())
            self._take("]")
        return name, field_type

    def _collection(self, element: FieldType, kind: str, size: int) -> FieldType:
        if element.kind != "scalar":
            self._refuse("arrays and sequences of arrays and sequences are no part of the definition of a message")
        return element._replace(kind=kind, size=size)

    def _size(self) -> int:
        digits = self._take("number")
        if not re.match(r"[1-9]\d{0,8}$", digits, re.ASCII):
            self._refuse(f"{digits} is not a size")
        return int(digits)

    def _type(self) -> FieldType:
        word = self._take("word", "::")
        if word == "sequence":
            return self._sequence()
        if word == "string":
            return FieldType("string", "scalar", 0, self._bound())
        if word in _NO_TYPES:
            self._refuse(f"the type {word} of IDL is not part of a message definition")
        if word in _PARTS:
            return self._primitive(word)
        return self._named("" if word == "::" else word)

    def _sequence(self) -> FieldType:
        self._take("<")
        element = self._type()
        size = self._size() if self._is_next(",") else 0
        self._take(">")
        return self._collection(element, "sequence", size)

    def _bound(self) -> int:
        if not self._is_next("<"):
            return 0
        bound = self._size()
        self._take(">")
        return bound

    def _primitive(self, word: str) -> FieldType:
        while f"{word} {self._next.text}" in _PRIMITIVES:
            word += f" {self._take('word')}"
        if word not in _PRIMITIVES or (word == "long" and self._next.text == "double"):
            self._refuse(f"the type {word} {self._next.text} of IDL is not part of a message definition")
        return FieldType(_PRIMITIVES[word], "scalar", 0, 0)

    def _named(self, word: str) -> FieldType:
        parts = [word or self._take("word")]
        while self._is_next("::"):
            parts.append(self._take("word"))
        known = (self._package, "msg")
        if parts[-1] in self._aliases and tuple(parts[:-1]) in ((), known, known[1:]):
            return self._aliases[parts[-1]]
        parts = [*known[: 3 - len(parts)], *parts]
        try:
            return FieldType(full_name("/".join(parts), self._package), "scalar", 0, 0)
        except ValueError as problem:
            self._refuse(str(problem))
