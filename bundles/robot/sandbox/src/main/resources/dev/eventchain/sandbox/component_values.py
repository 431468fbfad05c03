"""Encoding of values between a component and the process that calls it.

The processes do not trust each other: any bytes decode to a value or to a :class:`MalformedError`. The bytes of a value
are the length of its head (u32, little endian), the head, and parts. The head is JSON in ASCII, in which an object with
the name "" has no other one, and stands for something that JSON does not have::

    {"": ["bytes", length]}                   the next part
    {"": ["array", typecode, length]}         array.array, its content is the next part
    {"": ["floats", length]}                  a list of many floats, likewise: their digits would take longer
    {"": ["numpy", dtype, shape, length]}     numpy.ndarray, likewise
    {"": ["dict", [[key, value], ...]]}       a dict that has the key ""
    {"": ["message", type, {field: value}]}   an object that the caller's `Objects` know

So what most calls consist of, dicts of numbers, is written and read by the functions of Python's JSON in C.
"""

from __future__ import annotations

import json
import struct
from array import array
from collections.abc import Callable, Collection, Iterable
from typing import Any, NamedTuple

LONGEST = 1 << 26
"""Bytes of the longest value that is read."""

_LENGTH = struct.Struct("<I")
_SCALARS = frozenset({bool, int, float, str, type(None)})
_LEAVES = _SCALARS | {array, bytes, bytearray, memoryview}
_FLOATS = frozenset({float})
_MANY = 16
_TYPE_CODES = frozenset("bBhHiIlLqQfd")
_NUMPY_KINDS = frozenset("biuf")
_WIDEST = 8  # size of a number in bytes
# NumPy evaluates parts of other texts, which may then be anything.
_DTYPES = frozenset(
    ["|b1", "|i1", "|u1", "<f2", "<f4", "<f8", *(f"<{kind}{size}" for kind in "iu" for size in (2, 4, 8))]
)

Buffer = bytes | bytearray | memoryview


def _encoder(default: Callable[[Any], Any]) -> Callable[[Any], str]:
    """Return what encodes JSON, without the parts that Python's encoder makes anew for each value, if it has them."""
    plain = json.JSONEncoder(separators=(",", ":"), check_circular=False, default=default)
    try:
        parts: Any = json.encoder.c_make_encoder(  # type: ignore[attr-defined]
            None, default, json.encoder.encode_basestring_ascii, None, ":", ",", False, False, True
        )
        return lambda value: "".join(parts(value, 0))
    except (AttributeError, TypeError):
        return plain.encode


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


class PlainMessage:
    """A message whose class nobody has: its fields are attributes."""

    def __init__(self, name: str, fields: dict[str, Any]) -> None:
        self._name = name
        self.__dict__.update(fields)

    def __getattr__(self, name: str) -> Any:
        """Say that a message has no such field: it may be missing in a test, not in the type of messages."""
        if name.startswith("_"):
            raise AttributeError(name)  # asked of an object that is being copied, too
        raise AttributeError(f"the message {self!r} of this call has no '{name}'")

    def __repr__(self) -> str:
        return self._name + "(" + ", ".join(f"{key}={value!r}" for key, value in _fields(self).items()) + ")"


def _fields(message: PlainMessage) -> dict[str, Any]:
    return {key: value for key, value in vars(message).items() if key != "_name"}


def _plain_message(value: Any) -> tuple[str, dict[str, Any]] | None:
    return (value._name, _fields(value)) if type(value) is PlainMessage else None


PLAIN_OBJECTS = Objects(_plain_message, PlainMessage)
"""Messages without their classes, as checks of components give them."""


class Codec:
    """Writes and reads values, one after the other.

    Args:
        objects: objects that may be sent besides plain values.

    """

    def __init__(self, objects: Objects = NO_OBJECTS) -> None:
        self._objects = objects
        self._encode = _encoder(self._leaf)
        self._scan = json.JSONDecoder(object_hook=self._object).raw_decode
        self._parts: list[Any] = []  # of the value that is written
        self._rest = memoryview(b"")  # parts of the value that is read

    def write(self, value: Any) -> list[Any]:
        """Return the buffers that encode a value.

        Numbers of NumPy become numbers of Python, and tuples lists.

        Raises:
            TypeError: a part of it cannot be sent; the text names its type.

        """
        parts: list[Any] = []
        self._parts = parts
        try:
            head = self._encode(value if _is_usual((value,)) else self._plain(value)).encode("ascii")
        except RecursionError:
            raise TypeError("something that contains itself, or is nested too deep") from None
        except ValueError:  # of Python's limit for the text of integers
            raise TypeError("an integer of some thousand digits") from None
        return [_LENGTH.pack(len(head)), head, *parts]

    def _leaf(self, value: Any) -> Any:
        """Return what stands for a value that is a part."""
        if type(value) is array and value.typecode in _TYPE_CODES:
            return self._part("array", value.typecode, value.tobytes())  # it may grow before this is sent
        if isinstance(value, (bytes, bytearray, memoryview)):
            return self._part("bytes", bytes(value))
        raise TypeError(type(value).__name__)

    def _part(self, *description: Any) -> Any:
        *stated, content = description
        self._parts.append(content)
        return {"": [*stated, len(content)]}

    def _plain(self, value: Any) -> Any:
        kind = type(value)
        if kind in _SCALARS:
            return value
        if kind is list or kind is tuple:
            if _are_floats(value):
                return self._part("floats", array("d", value).tobytes())
            return [self._plain(item) for item in value]
        if isinstance(value, dict):
            plain = {_key(key): self._plain(item) for key, item in value.items()}
            return {"": ["dict", list(plain.items())]} if "" in plain else plain
        if kind in _LEAVES or isinstance(value, (bytes, bytearray)):
            return self._leaf(value)
        return self._uncommon(value)

    def _uncommon(self, value: Any) -> Any:
        described = self._objects.describe(value)
        if described is not None:
            name, fields = described
            return {"": ["message", name, {field: self._plain(item) for field, item in fields.items()}]}
        dtype: Any = getattr(value, "dtype", None)
        if getattr(dtype, "kind", "") in _NUMPY_KINDS and dtype.itemsize <= _WIDEST:
            if getattr(value, "shape", None) == ():
                return value.item()
            plain = dtype.newbyteorder("<")
            return self._part("numpy", plain.str, list(value.shape), value.astype(plain).tobytes())
        if isinstance(value, str):
            return _key(value)
        for base in (bool, int, float):
            if isinstance(value, base):  # an enumeration or another subclass
                return base(value)
        if isinstance(value, (list, tuple)):
            return [self._plain(item) for item in value]
        raise TypeError(type(value).__name__)

    def read(self, data: Buffer) -> Any:
        """Return the value that these bytes encode.

        Raises:
            MalformedError: they encode none.

        """
        view = memoryview(data)
        try:
            (length,) = _LENGTH.unpack_from(view)
            text = str(view[_LENGTH.size : _LENGTH.size + length], "ascii")
            self._rest = view[_LENGTH.size + length :]
            value, end = self._scan(text)
            if end != len(text):
                raise MalformedError("there is text left over")
        except _MALFORMED as problem:
            raise MalformedError(f"{type(problem).__name__}: {problem}"[:200]) from None
        if self._rest:
            raise MalformedError("there are bytes left over")
        return value

    def _object(self, plain: dict[str, Any]) -> Any:
        """Return what an object of the head stands for; those within it have been read."""
        if "" not in plain:
            return plain
        ((_, (name, *content)),) = plain.items()
        if name == "array":
            code, length = content
            if code not in _TYPE_CODES:
                raise MalformedError("an array of an unknown type")
            result = array(code)
            result.frombytes(self._next(length))
            return result
        if name == "floats":
            (length,) = content
            floats = array("d")
            floats.frombytes(self._next(length))
            return floats.tolist()
        if name == "bytes":
            (length,) = content
            return bytes(self._next(length))
        if name == "numpy":
            return self._numpy(*content)
        if name == "dict":
            (items,) = content
            return {_text(key): value for key, value in items}
        if name == "message":
            type_name, fields = content
            if type(fields) is not dict:
                raise MalformedError("a message without fields")
            return self._objects.make(_text(type_name), fields)
        raise MalformedError("an unknown kind of value")

    def _next(self, length: int) -> memoryview:
        """Return the next part."""
        if type(length) is not int or not 0 <= length <= len(self._rest):
            raise MalformedError("a part that is not there")
        part, self._rest = self._rest[:length], self._rest[length:]
        return part

    def _numpy(self, name: str, shape: list[int], length: int) -> Any:
        import numpy as np

        if name not in _DTYPES:
            raise MalformedError("an array of an unknown type")
        if any(type(size) is not int or size < 0 for size in shape):
            raise MalformedError("an array of an impossible shape")
        return np.frombuffer(self._next(length), name).reshape(shape).copy()


_MALFORMED = (
    struct.error,
    ValueError,
    TypeError,
    KeyError,
    AttributeError,
    RecursionError,
    OverflowError,
)


def _is_usual(values: Iterable[Any]) -> bool:
    """Return whether JSON's encoder writes these values, leaves apart, as they have to be written."""
    for value in values:
        kind = type(value)
        if kind in _LEAVES:
            continue
        if kind is dict:
            for key in value:
                if type(key) is not str or not key:
                    return False
            value = value.values()
        elif (kind is not list and kind is not tuple) or _are_floats(value):
            return False
        if not _is_usual(value):
            return False
    return True


def _are_floats(values: Collection[Any]) -> bool:
    return len(values) >= _MANY and _FLOATS.issuperset(map(type, values))


def _key(value: Any) -> str:
    """Return the text of a text, for an enumeration that of its value, or what `str` makes of something else."""
    return str.__str__(value) if isinstance(value, str) else str(value)


def _text(value: Any) -> str:
    if type(value) is not str:
        raise MalformedError("a name that is not text")
    return value
