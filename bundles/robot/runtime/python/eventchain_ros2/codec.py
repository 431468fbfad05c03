"""Generates the constructor, CDR writer and CDR reader of a message type as Python source, once per type.

The encoding is plain CDR version 1 (OMG DDS-XTypes 1.3, section 7.4.1), as in ROS 2: written in little endian, read in
both byte orders. Positions count from the end of the encapsulation header of four bytes. In a buffer with the header, a
position is a multiple of 8 if the length is 4 more than one.

Values are checked as rclpy's own classes check them, but when a message is written instead of when a field is set: the
generated code compares exact types, and other types go to the slow functions of `validation`.
"""

from __future__ import annotations

import functools
from array import array
from collections.abc import Callable
from math import gcd, inf, nan
from struct import Struct
from types import CodeType
from typing import Any, NamedTuple

from eventchain_ros2 import validation
from eventchain_ros2.definitions import CODES, Definition, Field

_PYTHON_TYPES = {"?": "bool", "c": "bytes", "f": "float", "d": "float"}
_ZEROS = {"?": False, "c": b"\0", "f": 0.0, "d": 0.0}
_PADDING = tuple(bytes(length) for length in range(8))
_LENGTH = Struct("<I")
_BIG_ENDIAN_LENGTH = Struct(">I")


class Codec(NamedTuple):
    """The generated functions of a message type."""

    initialize: Callable[..., None]  # __init__(self, **fields)
    write: Callable[[Any, bytearray], None]  # appends the message to a buffer that starts with the header
    read: Callable[[memoryview, int], tuple[Any, int]]  # buffer after the header, position -> message, next position
    read_big_endian: Callable[
        [memoryview, int], tuple[Any, int]
    ]  # generated on first use: hardly any sender uses big endian


class _BigEndianReader:
    """Reads big-endian messages with a function that is generated on first use."""

    def __init__(self, definition: Definition, message_class: type, nested: Callable[[str], type]) -> None:
        self._arguments = definition, message_class, nested
        self._read: Callable[[memoryview, int], tuple[Any, int]] | None = None

    def __call__(self, buffer: memoryview, position: int) -> tuple[Any, int]:
        if self._read is None:
            definition, message_class, nested = self._arguments
            self._read = _filled(_Generator(message_class, nested, ">"), definition).compile(definition.name)["read"]
        return self._read(buffer, position)


def generate(definition: Definition, message_class: type, nested: Callable[[str], type]) -> Codec:
    """Generate the functions of `message_class`; `nested` gives the classes of its nested messages."""
    functions = _filled(_Generator(message_class, nested, "<"), definition).compile(definition.name)
    big_endian = _BigEndianReader(definition, message_class, nested)
    return Codec(functions["initialize"], functions["write"], functions["read"], big_endian)


@functools.lru_cache(maxsize=1000)
def _compiled(source: str, name: str) -> CodeType:
    """Compile generated source once: each scenario has classes of its own, and all have the same code."""
    return compile(source, name, "exec")


def _filled(generator: _Generator, definition: Definition) -> _Generator:
    fields = definition.fields
    index = 0
    while index < len(fields):
        run = _scalar_run(fields, index)
        if run:
            generator.add_run(run)
        else:
            generator.add(fields[index])
        index += len(run) or 1
    if not fields:
        generator.add_placeholder()
    return generator


def _scalar_run(fields: list[Field], start: int) -> list[Field]:
    """Return the fields from `start` on that are primitive numbers of one size, and therefore without padding."""
    run: list[Field] = []
    for field in fields[start:]:
        code = CODES.get(field.type.base)
        if code is None or field.type.kind != "scalar" or (run and _size(code) != _size(CODES[run[0].type.base])):
            break
        run.append(field)
    return run


def _size(code: str) -> int:
    return Struct("<" + code).size


class _Generator:
    """Collects the lines of the three functions, field by field in wire order."""

    def __init__(self, message_class: type, nested: Callable[[str], type], order: str) -> None:
        self._nested = nested
        self._order = order  # byte order of the read function, `<` or `>`
        self._initialize: list[str] = []
        self._write: list[str] = []
        self._read: list[str] = []
        self._aligned = 1  # known alignment of the current position
        self._names: dict[str, Any] = {
            "C": message_class,
            "new": object.__new__,
            "array": array,
            "pad": _PADDING,
            "pack_length": _LENGTH.pack,
            "unpack_length": (_LENGTH if order == "<" else _BIG_ENDIAN_LENGTH).unpack_from,
            "nan": nan,
            "inf": inf,
            "check": validation.check,
            "as_array": validation.as_array,
            "as_ndarray": validation.as_ndarray,
        }

    def compile(self, name: str) -> dict[str, Any]:
        """Return a namespace with the functions `initialize`, `write` and `read`."""
        source = [
            "def initialize(self, **fields):",
            *self._indent(self._initialize),
            "  for name, value in fields.items():",
            "    if name not in self.__slots__:",
            "      raise AssertionError(f'Invalid arguments passed to constructor: {name}')",
            "    setattr(self, name, value)",
            "def write(m, o):",
            *self._indent(self._write),
            "def read(b, p):",
            "  m = new(C)",
            *self._indent(self._read),
            "  return m, p",
        ]
        exec(_compiled("\n".join(source), f"<codec of {name}>"), self._names)
        return self._names

    @staticmethod
    def _indent(lines: list[str]) -> list[str]:
        return ["  " + line for line in lines]

    def add_placeholder(self) -> None:
        """Add the one byte of a message without fields (rosidl: structure_needs_at_least_one_member)."""
        self._write.append("o += pad[1]")
        self._read.append("p += 1")

    def add_run(self, fields: list[Field]) -> None:
        codes = "".join(CODES[field.type.base] for field in fields)
        size = _size(codes[0])
        values = [f"v{index}" for index in range(len(fields))]
        for field, code in zip(fields, codes, strict=True):
            default = _ZEROS.get(code, 0) if field.default is None else python_value(field.type.base, field.default)
            self._initialize.append(f"self.{field.name} = {default!r}")
        struct = self._name("struct", Struct("<" + codes))
        self._align(size)
        types = " or ".join(
            f"type({v}) is not {_PYTHON_TYPES.get(c, 'int')}" for v, c in zip(values, codes, strict=True)
        )
        self._write += [f"{value} = m.{field.name}" for value, field in zip(values, fields, strict=True)]
        self._write += [f"if {types}: check(m)", f"o += {struct}.pack({', '.join(values)})"]
        targets = ", ".join(f"m.{field.name}" for field in fields)
        read = struct if self._order == "<" else self._name("struct", Struct(">" + codes))
        self._read += [f"{targets}, = {read}.unpack_from(b, p)", f"p += {size * len(fields)}"]
        self._aligned = gcd(self._aligned, size * len(fields))

    def add(self, field: Field) -> None:
        base, kind = field.type.base, field.type.kind
        if kind == "scalar":
            self._add_string(field) if base == "string" else self._add_message(field)
            return
        code = CODES.get(base)
        self._write.append(f"x = m.{field.name}")
        if code in ("?", "c"):
            self._add_byte_list(field, code)
        elif code is None:
            self._add_list(field)
        elif kind == "array":
            self._add_number_array(field, code)
        else:
            self._add_number_sequence(field, code)

    def _add_string(self, field: Field) -> None:
        self._initialize.append(f"self.{field.name} = {field.default or ''!r}")
        self._write.append(f"s = m.{field.name}.encode()")
        if field.type.string_bound:
            self._write.append(f"if len(s) > {field.type.string_bound}: check(m)")
        self._align(4)
        self._write.append("o += pack_length(len(s) + 1) + s + b'\\0'")
        self._read += ["n, = unpack_length(b, p)", "p += 4 + n", f"m.{field.name} = str(b[p - n:p - 1], 'utf-8')"]
        self._aligned = 1

    def _add_message(self, field: Field) -> None:
        cls, write, read = self._nested_names(field.type.base)
        self._initialize.append(f"self.{field.name} = {cls}()")
        self._write += [f"x = m.{field.name}", f"if type(x) is not {cls}: check(m)", f"{write}(x, o)"]
        self._read.append(f"m.{field.name}, p = {read}(b, p)")
        self._aligned = 1

    def _add_byte_list(self, field: Field, code: str) -> None:
        self._initialize.append(f"self.{field.name} = {_list_default(field, _ZEROS[code])}")
        item_type = _PYTHON_TYPES[code]
        self._write.append(f"if type(x) is not list or any(type(v) is not {item_type} for v in x): check(m)")
        self._add_length(field)
        self._write.append("o += bytes(x)" if code == "?" else "o += b''.join(x)")
        item = "v != 0" if code == "?" else "bytes((v,))"
        self._read += [f"m.{field.name} = [{item} for v in b[p:p + n]]", "p += n"]
        self._aligned = 1

    def _add_list(self, field: Field) -> None:
        """Add a list of strings or messages."""
        if field.type.base == "string":
            default = "''"
            write = ["s = v.encode()", "o += pad[-len(o) & 3]", "o += pack_length(len(s) + 1) + s + b'\\0'"]
            read = ["p += -p & 3", "k, = unpack_length(b, p)", "p += 4 + k", "x.append(str(b[p - k:p - 1], 'utf-8'))"]
            suspicious = "type(v) is not str"
            if field.type.string_bound:
                suspicious += f" or len(v.encode()) > {field.type.string_bound}"
        else:
            cls, write_name, read_name = self._nested_names(field.type.base)
            default = f"{cls}()"
            write = [f"{write_name}(v, o)"]
            read = [f"v, p = {read_name}(b, p)", "x.append(v)"]
            suspicious = f"type(v) is not {cls}"
        repeated = f"[{default} for _ in range({field.type.size if field.type.kind == 'array' else 0})]"
        self._initialize.append(f"self.{field.name} = {repeated if field.default is None else repr(field.default)}")
        self._write.append(f"if type(x) is not list or any({suspicious} for v in x): check(m)")
        self._add_length(field)
        self._write += ["for v in x:", *self._indent(write)]
        self._read += [f"m.{field.name} = x = []", "for _ in range(n):", *self._indent(read)]
        self._aligned = 1

    def _add_number_sequence(self, field: Field, code: str) -> None:
        values = "" if field.default is None else f", {field.default!r}"
        self._initialize.append(f"self.{field.name} = array('{code}'{values})")
        self._write.append(
            f"if type(x) is not array or x.typecode != '{code}': x = as_array(m, '{field.name}', '{code}')"
        )
        self._add_length(field)
        size = _size(code)
        # Without elements there is no padding.
        position = len(self._write), len(self._read)
        self._align(size)
        for lines, start in zip((self._write, self._read), position, strict=True):
            lines[start:] = [f"if n: {line}" for line in lines[start:]]
        self._write.append("o += x")
        self._read.append(f"m.{field.name} = x = array('{code}')")
        self._read += [f"x.frombytes(b[p:p + n * {size}])", f"p += n * {size}"]
        if self._order == ">" and size > 1:
            self._read.append("x.byteswap()")
        self._aligned = 1

    def _add_number_array(self, field: Field, code: str) -> None:
        import numpy as np  # slow to import, and needed for few types only

        count, size = field.type.size, _size(code)
        dtype = np.dtype("<" + np.dtype(code).str[1:]) if size > 1 else np.dtype(code)
        prototype = np.zeros(count, dtype) if field.default is None else np.array(field.default, dtype)
        dtype_name = self._name("dtype", dtype)
        self._names["ndarray"], self._names["frombuffer"] = np.ndarray, np.frombuffer
        self._initialize.append(f"self.{field.name} = {self._name('prototype', prototype)}.copy()")
        self._write.append(
            f"if type(x) is not ndarray or x.dtype != {dtype_name} or x.shape != ({count},): "
            f"x = as_ndarray(m, '{field.name}', {dtype_name}, {count})"
        )
        self._align(size)
        self._write.append("o += x.tobytes()")
        read = f"frombuffer(b, {dtype_name}, {count}, p).copy()"
        if self._order == ">" and size > 1:
            sent = self._name("dtype", dtype.newbyteorder(">"))
            read = f"frombuffer(b, {sent}, {count}, p).astype({dtype_name})"
        self._read += [f"m.{field.name} = {read}", f"p += {count * size}"]
        self._aligned = gcd(self._aligned, count * size)

    def _add_length(self, field: Field) -> None:
        """Write and check the number of elements of the list or array `x`; read it to `n`."""
        size = field.type.size
        self._write.append("n = len(x)")
        if field.type.kind == "array":
            self._write.append(f"if n != {size}: check(m)")
            self._read.append(f"n = {size}")
            return
        if size:
            self._write.append(f"if n > {size}: check(m)")
        self._align(4)
        self._write.append("o += pack_length(n)")
        self._read += ["n, = unpack_length(b, p)", "p += 4"]
        self._aligned = 4

    def _align(self, size: int) -> None:
        if self._aligned % size:
            length = "4 - len(o)" if size == 8 else "-len(o)"
            self._write.append(f"o += pad[{length} & {size - 1}]")
            self._read.append(f"p += -p & {size - 1}")
            self._aligned = size

    def _nested_names(self, base: str) -> tuple[str, str, str]:
        nested: Any = self._nested(base)
        return (
            self._name("C", nested),
            self._name("write", nested._write),
            self._name("read", nested._read if self._order == "<" else nested._read_big_endian),
        )

    def _name(self, prefix: str, value: object) -> str:
        name = f"{prefix}{len(self._names)}"
        self._names[name] = value
        return name


def _list_default(field: Field, zero: object) -> str:
    if isinstance(field.default, list):
        return repr([python_value(field.type.base, value) for value in field.default])
    return f"[{zero!r}] * {field.type.size if field.type.kind == 'array' else 0}"


def python_value(base: str, value: Any) -> Any:
    """Return the value of a primitive in rclpy's representation: a byte is `bytes` of length 1."""
    return bytes((value,)) if base == "byte" else value
