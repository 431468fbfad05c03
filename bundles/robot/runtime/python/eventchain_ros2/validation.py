"""Validation of field values as in rclpy's message classes, done when a message is written.

The generated codecs call this only for values whose exact type is unexpected, so it may be slow.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence, Set
from math import isfinite
from typing import TYPE_CHECKING, Any

from eventchain_ros2.definitions import CODES, PRIMITIVES, Field

if TYPE_CHECKING:
    import numpy as np

_RANGES = {f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)}
_RANGES.update({f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)})
_RANGES["char"] = _RANGES["uint8"]
_MAXIMAL_FLOAT32 = 3.402823466e38
_FLOATS, _INTEGERS = frozenset({float}), frozenset({int, bool})
_TYPES: dict[str, type] = {"bool": bool, "byte": bytes, "float32": float, "float64": float, "string": str}


def check(message: Any) -> None:
    """Check all fields of a message.

    Raises:
        AssertionError: a field holds a value that rclpy would not accept; the text names field, type and value.

    """
    for field in message._definition.fields:
        value = getattr(message, field.name)
        problem = _problem(field, value)
        if problem:
            raise AssertionError(
                f"The '{field.name}' field of {message._definition.name} {problem}, not {_shown(value)}"
            )
        if field.type.base not in PRIMITIVES:
            for item in value if field.type.kind != "scalar" else (value,):
                check(item)


def as_array(message: Any, name: str, code: str) -> Any:
    """Return the value of a sequence of numbers in a form that can be appended to a buffer."""
    value = getattr(message, name)
    if code == "B" and isinstance(value, (bytes, bytearray)):
        return value
    numbers = _numbers(value, code)
    if numbers is not None:
        return numbers
    check(message)
    return array(code, value)


def _numbers(value: Any, code: str) -> array[Any] | None:
    """Return the array of a list whose numbers are plain and in range, as most are; None if that has to be checked."""
    if type(value) is not list or not (_FLOATS if code in "fd" else _INTEGERS).issuperset(map(type, value)):
        return None
    if code == "f" and max(map(abs, filter(isfinite, value)), default=0.0) > _MAXIMAL_FLOAT32:
        return None
    try:
        return array(code, value)
    except OverflowError:
        return None


def as_ndarray(message: Any, name: str, dtype: np.dtype[Any], count: int) -> Any:
    """Return the value of a fixed array of numbers as a NumPy array."""
    import numpy as np

    check(message)
    return np.array(getattr(message, name), dtype).reshape(count)


def _problem(field: Field, value: Any) -> str:
    kind, size = field.type.kind, field.type.size
    if kind == "scalar":
        return "" if _accepts(field, value) else f"must be {_expected(field)}"
    if _is_number_array(field, value):
        items: Any = ()
    elif isinstance(value, (Sequence, Set)) and not isinstance(value, str):
        items = value
    else:
        return f"must be a set or sequence of {_expected(field)}{_hint(value)}"
    if kind == "array" and len(value) != size:
        return f"must have {size} elements"
    if kind == "sequence" and size and len(value) > size:
        return f"must have at most {size} elements"
    if not all(_accepts(field, item) for item in items):
        return f"must be a set or sequence and each value {_expected(field)}"
    return ""


def _is_number_array(field: Field, value: Any) -> bool:
    """Return whether the value has the array type that rclpy itself uses for this field."""
    code = CODES.get(field.type.base, "?")
    if code in "?c":
        return False
    if field.type.kind == "sequence":
        return isinstance(value, array) and value.typecode == code
    return type(value).__name__ == "ndarray" and value.ndim == 1 and value.dtype.char == code


def _accepts(field: Field, value: Any) -> bool:
    base = field.type.base
    if base not in PRIMITIVES:
        return bool(getattr(type(value), "_definition", None) and type(value)._definition.name == base)
    if base in _RANGES:
        low, high = _RANGES[base]
        return isinstance(value, int) and low <= value <= high
    if base == "float32":
        return isinstance(value, float) and (not isfinite(value) or abs(value) <= _MAXIMAL_FLOAT32)
    if base == "byte":
        return isinstance(value, bytes) and len(value) == 1
    if base == "string":
        bound = field.type.string_bound
        return isinstance(value, str) and (not bound or len(value.encode()) <= bound)
    return isinstance(value, _TYPES[base])


def _expected(field: Field) -> str:
    base = field.type.base
    if base in _RANGES:
        low, high = _RANGES[base]
        return f"of type 'int' in [{low}, {high}]"
    if base == "float32":
        return "of type 'float' in the range of float32"
    if base == "byte":
        return "of type 'bytes' and of length 1"
    bound = f" of at most {field.type.string_bound} bytes" if field.type.string_bound else ""
    return f"of type '{_TYPES[base].__name__}'{bound}" if base in _TYPES else f"of type '{base}'"


def _hint(value: object) -> str:
    return " (numpy arrays have tolist())" if type(value).__name__ == "ndarray" else ""


def _shown(value: object) -> str:
    text = repr(value)
    return f"{text if len(text) <= 60 else text[:57] + '...'} ({type(value).__name__})"
