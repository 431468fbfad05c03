"""Encoding of values between a component and the process that calls it.

The processes do not trust each other: any bytes decode to a value or to a :class:`MalformedError`. The bytes of a value
are the length of its head (u32, little endian), the head, and parts. The head is JSON in ASCII, in which an object has
one member that names what it stands for::

    {"bytes": length}                      the next part
    {"array": [typecode, length]}          array.array, its content is the next part
    {"numpy": [dtype, shape, length]}      numpy.ndarray, likewise
    {"dict": {key: value, ...}}
    {"message": [type, {field: value}]}    an object that the caller's `Objects` know
"""

from __future__ import annotations

import json
import struct
from array import array
from collections.abc import Callable
from typing import Any, NamedTuple

LONGEST = 1 << 26
"""Bytes of the longest value that is read."""

_LENGTH = struct.Struct("<I")
_SCALARS = frozenset({bool, int, float, str, type(None)})
_TYPE_CODES = frozenset("bBhHiIlLqQfd")
_NUMPY_KINDS = frozenset("biuf")
_WIDEST = 8  # size of a number in bytes
_decode = json.JSONDecoder().raw_decode

Buffer = bytes | bytearray | memoryview


def _encoder() -> Callable[[Any], str]:
    """Return what encodes JSON, without the parts that Python's encoder makes anew for each value, if it has them."""
    plain = json.JSONEncoder(separators=(",", ":"), check_circular=False)
    try:
        parts: Any = json.encoder.c_make_encoder(  # type: ignore[attr-defined]
            None, plain.default, json.encoder.encode_basestring_ascii, None, ":", ",", False, False, True
        )
        return lambda value: "".join(parts(value, 0))
    except (AttributeError, TypeError):
        return plain.encode


_encode = _encoder()


class MalformedError(ValueError):
    """Bytes that do not encode a value."""


class Objects(NamedTuple):
    """The objects besides plain values that may be sent, such as messages with several fields.

    `describe` gives the name of an object's type and its fields, or None for other objects; `make` is its inverse and
    raises `KeyError`, `TypeError` or `ValueError` on failure.
    """

    describe: Callable[[Any], tuple[str, dict[str, Any]] | None]
    make: Callable[[str, dict[str, Any]], Any]


def _no_type(name: str, _: dict[str, Any]) -> Any:
    raise KeyError(name)


NO_OBJECTS = Objects(lambda _: None, _no_type)


def write(value: Any, objects: Objects = NO_OBJECTS) -> list[Any]:
    """Return the buffers that encode a value.

    Numbers of NumPy become numbers of Python, and tuples lists.

    Raises:
        TypeError: a part of it cannot be sent; the text names its type.

    """
    parts: list[Any] = []
    try:
        head = _encode(_plain(value, parts, objects)).encode("ascii")
    except RecursionError:
        raise TypeError("something that contains itself, or is nested too deep") from None
    return [_LENGTH.pack(len(head)), head, *parts]


def _plain(value: Any, parts: list[Any], objects: Objects) -> Any:
    kind = type(value)
    if kind in _SCALARS:
        return value
    if kind is array and value.typecode in _TYPE_CODES:
        parts.append(memoryview(value).cast("B") if len(value) else b"")
        return {"array": [value.typecode, len(parts[-1])]}
    if kind is list or kind is tuple:
        return [item if type(item) in _SCALARS else _plain(item, parts, objects) for item in value]
    if isinstance(value, (bytes, bytearray, memoryview)):
        parts.append(bytes(value))
        return {"bytes": len(parts[-1])}
    if isinstance(value, dict):
        return {
            "dict": {
                key if type(key) is str else str(key): item if type(item) in _SCALARS else _plain(item, parts, objects)
                for key, item in value.items()
            }
        }
    return _uncommon(value, parts, objects)


def _uncommon(value: Any, parts: list[Any], objects: Objects) -> Any:
    described = objects.describe(value)
    if described is not None:
        name, fields = described
        return {"message": [name, {field: _plain(item, parts, objects) for field, item in fields.items()}]}
    dtype: Any = getattr(value, "dtype", None)
    if getattr(dtype, "kind", "") in _NUMPY_KINDS and dtype.itemsize <= _WIDEST:
        if getattr(value, "shape", None) == ():
            return value.item()
        plain = dtype.newbyteorder("<")
        parts.append(value.astype(plain).tobytes())
        return {"numpy": [plain.str, list(value.shape), len(parts[-1])]}
    for base in (bool, int, float, str):
        if isinstance(value, base):  # an enumeration or another subclass
            return base(value)
    if isinstance(value, (list, tuple)):
        return [_plain(item, parts, objects) for item in value]
    raise TypeError(type(value).__name__)


def read(data: Buffer, objects: Objects = NO_OBJECTS) -> Any:
    """Return the value that these bytes encode.

    Raises:
        MalformedError: they encode none.

    """
    view = memoryview(data)
    try:
        (length,) = _LENGTH.unpack_from(view)
        text = str(view[_LENGTH.size : _LENGTH.size + length], "ascii")
        head, end = _decode(text)
        if end != len(text):
            raise MalformedError("there is text left over")
        reader = _Reader(view[_LENGTH.size + length :], objects)
        value = reader.value(head)
    except (struct.error, ValueError, TypeError, KeyError, AttributeError, RecursionError, OverflowError) as problem:
        raise MalformedError(f"{type(problem).__name__}: {problem}"[:200]) from None
    if reader.rest:
        raise MalformedError("there are bytes left over")
    return value


class _Reader:
    def __init__(self, parts: memoryview, objects: Objects) -> None:
        self.rest = parts
        self._objects = objects

    def value(self, plain: Any) -> Any:
        kind = type(plain)
        if kind in _SCALARS:
            return plain
        if kind is list:
            return [item if type(item) in _SCALARS else self.value(item) for item in plain]
        ((name, content),) = plain.items()
        if name == "array":
            code, length = content
            if code not in _TYPE_CODES:
                raise MalformedError("an array of an unknown type")
            result = array(code)
            result.frombytes(self._part(length))
            return result
        if name == "bytes":
            return bytes(self._part(content))
        if name == "numpy":
            return self._numpy(*content)
        if name == "dict":
            return {key: item if type(item) in _SCALARS else self.value(item) for key, item in content.items()}
        if name == "message":
            type_name, fields = content
            return self._objects.make(_text(type_name), {key: self.value(item) for key, item in fields.items()})
        raise MalformedError("an unknown kind of value")

    def _part(self, length: int) -> memoryview:
        if type(length) is not int or not 0 <= length <= len(self.rest):
            raise MalformedError("a part that is not there")
        part, self.rest = self.rest[:length], self.rest[length:]
        return part

    def _numpy(self, name: str, shape: list[int], length: int) -> Any:
        import numpy as np

        dtype = np.dtype(_text(name))
        if dtype.kind not in _NUMPY_KINDS or dtype.itemsize > _WIDEST or dtype.names is not None:
            raise MalformedError("an array of an unknown type")
        if any(type(size) is not int or size < 0 for size in shape):
            raise MalformedError("an array of an impossible shape")
        return np.frombuffer(self._part(length), dtype).reshape(shape).copy()


def _text(value: Any) -> str:
    if type(value) is not str:
        raise MalformedError("a name that is not text")
    return value
