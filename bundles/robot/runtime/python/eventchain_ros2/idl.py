"""Message classes in the form of `cyclonedds.idl`, on the codecs of this runtime.

A subclass of `IdlStruct` is a dataclass whose annotations define the encoding. A class is analysed on its first use
with a topic: only then it is a dataclass, and its nested classes are known.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, NamedTuple, get_args, get_type_hints

from eventchain_ros2 import codec
from eventchain_ros2.definitions import PRIMITIVES, Definition, Field, FieldType, message_name

_PLAIN = {bool: "bool", str: "string", int: "int64", float: "float64"}


class Bounds(NamedTuple):
    """Constraints of an annotation besides the value type; `kind` is that of a `FieldType`, or `text`."""

    subtype: Any
    kind: str
    size: int


class sequence:  # noqa: N801 - the name in cyclonedds
    """A sequence of any length, or with a bound: `sequence[int32]`, `sequence[int32, 5]`."""

    def __class_getitem__(cls, parameters: Any) -> Any:
        subtype, size = parameters if isinstance(parameters, tuple) else (parameters, 0)
        return Annotated[Sequence[Any], Bounds(subtype, "sequence", size)]


class array:  # noqa: N801 - the name in cyclonedds
    """An array of fixed length: `array[float64, 9]`."""

    def __class_getitem__(cls, parameters: Any) -> Any:
        subtype, size = parameters
        return Annotated[Sequence[Any], Bounds(subtype, "array", size)]


class bounded_str:  # noqa: N801 - the name in cyclonedds
    """A string with at most this many bytes: `bounded_str[10]`."""

    def __class_getitem__(cls, size: int) -> Any:
        return Annotated[str, Bounds(str, "text", size)]


class IdlStruct:
    """Base of message classes: `class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_")`."""

    __idl_typename__: ClassVar[str] = ""
    _definition: ClassVar[Definition]

    def __init_subclass__(cls, typename: str = "", **options: Any) -> None:
        super().__init_subclass__(**options)
        cls.__idl_typename__ = typename or f"{cls.__module__}.{cls.__qualname__}"


def prepare(data_type: Any) -> None:
    """Add the functions that write and read a message class and its nested classes.

    Raises:
        TypeError: it is not a message class, or has an annotation outside `cyclonedds.idl`.

    """
    if not (isinstance(data_type, type) and issubclass(data_type, IdlStruct)):
        raise TypeError(f"{data_type!r} is not a subclass of cyclonedds.idl.IdlStruct")
    if "_definition" in vars(data_type):
        return
    nested: dict[str, Any] = {}
    hints = get_type_hints(data_type, include_extras=True)
    fields = [Field(name, _field_type(hints[name], nested), None) for name in data_type.__annotations__]
    message_class: Any = data_type
    message_class._definition = Definition(message_name(data_type.__idl_typename__), fields, [])
    functions = codec.generate(message_class._definition, data_type, nested.__getitem__)
    message_class._write = functions.write
    message_class._read = staticmethod(functions.read)
    message_class._read_big_endian = functions.read_big_endian


def _field_type(hint: Any, nested: dict[str, Any]) -> FieldType:
    bounds = get_args(hint)[1] if hasattr(hint, "__metadata__") else None
    if isinstance(bounds, Bounds) and bounds.kind != "text":
        item = _field_type(bounds.subtype, nested)
        if item.kind == "scalar":
            return item._replace(kind=bounds.kind, size=bounds.size)
    elif isinstance(bounds, Bounds):
        return FieldType("string", "scalar", 0, bounds.size)
    elif bounds in PRIMITIVES:
        return FieldType("uint8" if bounds == "byte" else bounds, "scalar", 0, 0)
    elif hint in _PLAIN:
        return FieldType(_PLAIN[hint], "scalar", 0, 0)
    elif isinstance(hint, type) and issubclass(hint, IdlStruct):
        prepare(hint)
        nested[hint._definition.name] = hint
        return FieldType(hint._definition.name, "scalar", 0, 0)
    raise TypeError(f"{hint!r} is not a type that this runtime knows of cyclonedds.idl")
