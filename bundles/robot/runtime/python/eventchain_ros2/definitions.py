"""Message definitions: what they say, and the `.msg` language of ROS 2.

The language is that of https://docs.ros.org/en/humble/Concepts/Basic/About-Interfaces.html without `wstring`.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterator, Mapping
from math import isfinite
from typing import Any, NamedTuple

_LITERALS = {"bool": bool, "byte": int, "char": int, "float32": float, "float64": float, "string": str}
_LITERALS.update({f"{sign}int{bits}": int for sign in ("", "u") for bits in (8, 16, 32, 64)})
PRIMITIVES = frozenset(_LITERALS)

# struct codes; also those of `array.array`, except for `?` and `c`, whose sequences are Python lists
CODES = {"bool": "?", "byte": "c", "char": "B", "float32": "f", "float64": "d"}
CODES.update({"int8": "b", "int16": "h", "int32": "i", "int64": "q"})
CODES.update({"uint8": "B", "uint16": "H", "uint32": "I", "uint64": "Q"})

_TYPE = re.compile(
    r"(?P<base>[A-Za-z][\w/]*)(<=(?P<string>0*[1-9]\d{0,8}))?(\[((?P<bound><=)?(?P<size>0*[1-9]\d{0,8}))?\])?",
    re.ASCII,
)
_WORD = re.compile(r"[A-Za-z]\w*", re.ASCII)
_FIELD = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
_CONSTANT = re.compile(r"[A-Z][A-Z0-9]*(_[A-Z0-9]+)*")
FULL_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*/msg/[A-Z][A-Za-z0-9]*")
_QUOTED = re.compile(r"\"(\\\"|[^\"])*\"|'(\\'|[^'])*'")
_MAXIMAL_FLOAT32 = 3.4028235677973366e38  # from here on, the nearest one is infinite

_WIRE_NAME = re.compile(r"(\w+)::(\w+)::dds_::(\w+)_$", re.ASCII)

RANGES = {f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)}
RANGES.update({f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)})
RANGES["byte"] = RANGES["char"] = RANGES["uint8"]

Value = bool | int | float | str


def message_name(type_name: str) -> str:
    """The name under which ROS 2 knows a type of the wire, `std_msgs/msg/Bool`; the same if it is none of ROS 2."""
    match = _WIRE_NAME.match(type_name)
    return "/".join(match.groups()) if match else type_name


class MessageDefinitionError(Exception):
    """A message definition cannot be used; `file` and `line` (1-based, 0 unknown) say where."""

    def __init__(self, message: str, file: str, line: int) -> None:
        super().__init__(message)
        self.file = file
        self.line = line


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
    """A message type; `name` is its full name (`std_msgs/msg/Header`), `file` where it is defined."""

    name: str
    file: str
    fields: list[Field]
    constants: list[Constant]


def parse(name: str, text: str, file: str) -> Definition:
    """Read the definition of one message type.

    Raises:
        MessageDefinitionError: the text is no message definition.

    """
    definition = Definition(name, file, [], [])
    for number, line in enumerate(text.splitlines(), 1):
        code = line.partition("#")[0].strip()
        if code:
            try:
                _parse_line(definition, code.replace("\t", " "))
            except ValueError as problem:
                raise MessageDefinitionError(f"{name}: {problem}", file, number) from None
    return definition


def _parse_line(definition: Definition, code: str) -> None:
    type_text, _, rest = code.partition(" ")
    rest = rest.strip()
    field_type = _parse_type(type_text, definition.name.partition("/")[0])
    constant, equals, value = rest.partition("=")
    if equals:
        _add_constant(definition, field_type, constant.strip(), value)
        return
    field, _, default = rest.partition(" ")
    if not _FIELD.fullmatch(field):
        raise ValueError(f"'{field}' cannot be the name of a field")
    check_name(definition, field)
    definition.fields.append(Field(field, field_type, default_value(field_type, default.strip())))


def _add_constant(definition: Definition, field_type: FieldType, name: str, value: str) -> None:
    if not _CONSTANT.fullmatch(name):
        raise ValueError(f"'{name}' cannot be the name of a constant")
    check_name(definition, name)
    if field_type.kind != "scalar" or field_type.string_bound or field_type.base not in PRIMITIVES:
        raise ValueError("the type of a constant is primitive, without a size or bound")
    definition.constants.append(Constant(name, field_type.base, literal(field_type.base, value)))


def _parse_type(text: str, package: str) -> FieldType:
    match = _TYPE.fullmatch(text)
    if match is None or (match["string"] and match["base"] != "string"):
        raise ValueError(f"'{text}' is not a type")
    base = match["base"]
    if base not in PRIMITIVES:
        base = full_name(base, package)
    kind = "scalar"
    if text.endswith("]"):
        kind = "array" if match["size"] and not match["bound"] else "sequence"
    return FieldType(base, kind, int(match["size"] or 0), int(match["string"] or 0))


def full_name(text: str, package: str) -> str:
    """The full name of a message type that a definition of the package names; `ValueError` if it is none."""
    parts = text.split("/")
    if parts == ["Header"]:
        return "std_msgs/msg/Header"
    if len(parts) == 1:
        parts = [package, text]
    if len(parts) == 2:
        parts.insert(1, "msg")
    name = "/".join(parts)
    if not FULL_NAME.fullmatch(name):
        raise ValueError(f"'{text}' is neither a primitive type nor a message type")
    return name


def check_name(definition: Definition, name: str) -> None:
    """Raise `ValueError` if a field or constant that is added cannot have this name."""
    if not _WORD.fullmatch(name) or keyword.iskeyword(name):
        raise ValueError(f"'{name}' cannot be the name of a field or constant")
    if name in [field.name for field in definition.fields] + [constant.name for constant in definition.constants]:
        raise ValueError(f"'{name}' is defined twice")


def default_value(field_type: FieldType, text: str) -> Value | list[Value] | None:
    """The value that a field starts with, `[1, 2]` for arrays; `ValueError` if it is not such a value."""
    if not text:
        return None
    if field_type.base not in PRIMITIVES:
        raise ValueError(f"a field of type {field_type.base} cannot have a default value")
    if field_type.kind == "scalar":
        return _bounded(field_type, literal(field_type.base, text))
    if not (text.startswith("[") and text.endswith("]")):
        raise ValueError(f"the default value {text} of an array has to stand in brackets")
    separate = _texts if field_type.base == "string" else _separated
    items = [_bounded(field_type, literal(field_type.base, item)) for item in separate(text[1:-1])]
    if field_type.size and (
        len(items) > field_type.size or (field_type.kind == "array" and len(items) != field_type.size)
    ):
        raise ValueError(f"the default value {text} has {len(items)} elements instead of {field_type.size}")
    return items


def _bounded(field_type: FieldType, value: Value) -> Value:
    bound = field_type.string_bound
    if bound and isinstance(value, str) and len(value.encode()) > bound:
        raise ValueError(f"'{value}' has more than {bound} bytes")
    return value


def _separated(text: str) -> list[str]:
    return text.split(",") if text else []


def _texts(text: str) -> Iterator[str]:
    """Texts between commas, which may be part of a text in quotes."""
    rest = text
    while rest:
        rest = rest.lstrip()
        if not rest or rest.startswith(","):
            raise ValueError(f"a value is missing in [{text}]")
        quoted = _QUOTED.match(rest)
        if rest[0] in "'\"" and not quoted:
            raise ValueError(f"the closing quote of {rest} is missing")
        item = quoted[0] if quoted else rest.partition(",")[0]
        yield _unquoted(item) if quoted else item
        rest = rest[len(item) :].lstrip().removeprefix(",")


def _unquoted(text: str) -> str:
    """Without the quotes around it; those within it have a backslash then, and lose that."""
    for quote in "\"'":
        if text.startswith(quote) and text.endswith(quote):
            inner = text[1:-1]
            if re.search(rf"(?<!\\){quote}", inner):
                raise ValueError(f"a quote within a string in quotes needs a backslash, \\{quote}")
            return inner.replace(f"\\{quote}", quote)
    return text


def literal(base: str, text: str) -> Value:
    """A single value of a primitive type; `ValueError` if it is none."""
    text = text.strip()
    if base != "string" and not text.isascii():
        raise ValueError(f"'{text}' is not a value of {base}")
    if base == "bool":
        if text.lower() not in ("true", "false", "0", "1"):
            raise ValueError(f"'{text}' is not a bool")
        return text.lower() in ("true", "1")
    if base == "string":
        return _unquoted(text)
    if base.startswith("float"):
        return _float(base, text)
    return _integer(base, text)


def _float(base: str, text: str) -> float:
    value = float(text)
    if base == "float32" and isfinite(value) and abs(value) >= _MAXIMAL_FLOAT32:
        raise ValueError(f"{text} is out of the range of float32")
    return value


def _integer(base: str, text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = int(text, 0)
    low, high = RANGES[base]
    if not low <= value <= high:
        raise ValueError(f"{text} is out of the range of {base}")
    return value


_RESOLVED_TYPE = re.compile(r"(?P<base>[\w/]+)(<=(?P<string>\d+))?(?P<many>\[(?P<bound><=)?(?P<size>\d*)\])?", re.ASCII)


def resolved(name: str, stated: Mapping[str, Any]) -> Definition:
    """A definition that was resolved elsewhere, as JSON holds it.

    Args:
        name: full name of the message type.
        stated: `fields`, each a list of its name, its type and its default, if there is one; `constants`, likewise.

    """
    fields = []
    for field, type_text, *default in stated["fields"]:
        field_type = _resolved_type(type_text)
        fields.append(Field(field, field_type, _resolved_value(field_type.base, default[0]) if default else None))
    constants = []
    for constant, base, value in stated["constants"]:
        constants.append(Constant(constant, base, _resolved_value(base, value)))
    return Definition(name, "", fields, constants)


def _resolved_type(text: str) -> FieldType:
    match = _RESOLVED_TYPE.fullmatch(text)
    if match is None:
        raise ValueError(f"{text} is no type")
    kind = "scalar" if not match["many"] else "array" if match["size"] and not match["bound"] else "sequence"
    return FieldType(match["base"], kind, int(match["size"] or 0), int(match["string"] or 0))


def _resolved_value(base: str, value: Any) -> Any:
    if isinstance(value, list):
        return [_resolved_value(base, item) for item in value]
    return float(value) if base in ("float32", "float64") else value  # nan and inf are texts
