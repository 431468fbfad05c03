"""Message definitions, as they were resolved from `.msg` and IDL files: see decision 028."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, NamedTuple

# struct codes; also those of `array.array`, except for `?` and `c`, whose sequences are Python lists
CODES = {"bool": "?", "byte": "c", "char": "B", "float32": "f", "float64": "d"}
CODES.update({"int8": "b", "int16": "h", "int32": "i", "int64": "q"})
CODES.update({"uint8": "B", "uint16": "H", "uint32": "I", "uint64": "Q"})
PRIMITIVES = frozenset((*CODES, "string"))

_FLOATS = ("float32", "float64")
_TYPE = re.compile(r"(?P<base>[\w/]+)(<=(?P<string>\d+))?(?P<many>\[(?P<bound><=)?(?P<size>\d*)\])?", re.ASCII)
_WIRE_NAME = re.compile(r"(\w+)::(\w+)::dds_::(\w+)_$", re.ASCII)

Value = bool | int | float | str


def message_name(type_name: str) -> str:
    """Return the ROS 2 name of a DDS type, `std_msgs/msg/Bool`; unchanged if it is not a ROS 2 type."""
    match = _WIRE_NAME.match(type_name)
    return "/".join(match.groups()) if match else type_name


class MessageDefinitionError(Exception):
    """Message definitions cannot be used; `file` says where they are, if in one."""

    def __init__(self, message: str, file: str = "") -> None:
        super().__init__(message)
        self.file = file


class FieldType(NamedTuple):
    """The type of a field.

    `base` is a primitive type or the full name of a message (`std_msgs/msg/Header`). `kind` is `scalar`, `array` or
    `sequence`; `size` is the length of an array and the bound of a sequence, `string_bound` that of a string (0: none).
    """

    base: str
    kind: str
    size: int
    string_bound: int


class Field(NamedTuple):
    """A field and its default value, if the definition states one."""

    name: str
    type: FieldType
    default: Value | list[Value] | None


class Constant(NamedTuple):
    """A constant of a message type."""

    name: str
    base: str
    value: Value


class Definition(NamedTuple):
    """A message type; `name` is its full name (`std_msgs/msg/Header`)."""

    name: str
    fields: list[Field]
    constants: list[Constant]


def resolved(name: str, stated: Mapping[str, Any]) -> Definition:
    """A definition as JSON holds it.

    Args:
        name: full name of the message type.
        stated: `fields`, each a list of its name, its type and an optional default; `constants`, likewise.

    Raises:
        MessageDefinitionError: it is none.

    """
    try:
        return Definition(name, list(map(_field, stated["fields"])), list(map(_constant, stated["constants"])))
    except (KeyError, TypeError, ValueError) as problem:
        raise MessageDefinitionError(f"{name} is not defined as `eventchain messages` writes it: {problem!r}") from None


def _field(stated: list[Any]) -> Field:
    name, type_text, *default = stated
    match = _TYPE.fullmatch(type_text)
    if match is None:
        raise ValueError(type_text)
    kind = "scalar" if not match["many"] else "array" if match["size"] and not match["bound"] else "sequence"
    field_type = FieldType(match["base"], kind, int(match["size"] or 0), int(match["string"] or 0))
    return Field(name, field_type, _value(field_type.base, default[0]) if default else None)


def _constant(stated: list[Any]) -> Constant:
    name, base, value = stated
    return Constant(name, base, _value(base, value))


def _value(base: str, value: Any) -> Any:
    if isinstance(value, list):
        return [_value(base, item) for item in value]
    return float(value) if base in _FLOATS else value  # nan and inf are texts
