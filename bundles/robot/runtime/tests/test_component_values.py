"""What passes between a component and its caller: values come back as they were, and other bytes are refused."""

from __future__ import annotations

import copy
import enum
import math
import random
import struct
from array import array
from collections import OrderedDict
from typing import Any

import numpy as np
import pytest
from component_values import PLAIN_OBJECTS, Codec, MalformedError, Objects, PlainMessage

MUTANTS = 5_000


class Point:
    """An object that the codec is told about."""

    def __init__(self, **fields: Any) -> None:
        self.fields = fields

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Point) and self.fields == other.fields

    __hash__ = None  # type: ignore[assignment]


class Gear(enum.IntEnum):
    """An enumeration, which becomes a number."""

    FORWARD = 1


class Mode(str, enum.Enum):
    """An enumeration of texts, which becomes its text."""

    COMFORT = "comfort"


POINTS = Objects(
    lambda value: ("Point", value.fields) if isinstance(value, Point) else None, lambda _, fields: Point(**fields)
)


def encoded(value: Any) -> bytes:
    return b"".join(map(bytes, Codec(POINTS).write(value)))


def head(text: str, parts: bytes = b"") -> bytes:
    return struct.pack("<I", len(text)) + text.encode() + parts


@pytest.mark.parametrize(
    "value",
    [
        None,
        1 << 70,
        -0.0,
        "text with \u00e9 and \U0001f600 and \ud800",
        ["call", [], {"ttc": 3.25, "is_late": False, "none": None, "name": "x"}],
        {"": 1, "other": {"": {"": [{}, {"a": array("d", [1.5])}]}}},
        {"array": ["B", 3], "message": "Point", "dict": {"bytes": 4}},
        [b"", b"\x00\xff", array("f"), array("q", [-(1 << 63)]), {"inner": [array("B", b"abc"), b"d"]}],
        [Point(x=1, data=array("B", b"xy"), inner=[Point(), {"": b"z"}]), b"last"],
    ],
)
def test_values_come_back(value: Any) -> None:
    codec = Codec(POINTS)
    for _ in range(2):  # nothing of one value is left in the next one
        assert codec.read(b"".join(map(bytes, codec.write(value)))) == value


@pytest.mark.parametrize(
    ("value", "read"),
    [
        ((1, (2, ())), [1, [2, []]]),
        ({True: 1, None: {2: 3.5}}, {"True": 1, "None": {"2": 3.5}}),
        (OrderedDict(a=Gear.FORWARD), {"a": 1}),
        ({Mode.COMFORT: [Mode.COMFORT]}, {"comfort": ["comfort"]}),
        ([np.float64(0.1), np.float32(0.5), np.int64(7), np.bool_(True)], [0.1, 0.5, 7, True]),
        (bytearray(b"ab"), b"ab"),
        (memoryview(b"ab"), b"ab"),
    ],
)
def test_what_is_not_plain_becomes_so(value: Any, read: Any) -> None:
    back = Codec().read(encoded(value))
    assert back == read
    assert type(back) is type(read)


def test_numbers_that_are_none_come_back() -> None:
    back = Codec().read(encoded([math.nan, math.inf, -math.inf]))
    assert math.isnan(back[0])
    assert back[1:] == [math.inf, -math.inf]


@pytest.mark.parametrize("other", [None, 1, True, 0.25])
def test_lists_of_many_numbers_come_back(other: Any) -> None:
    value = [0.1, -0.0, math.inf, -math.inf, 5e-324, 1.7976931348623157e308, *(1 / (n + 1) for n in range(30)), other]
    back = Codec().read(encoded({"": tuple(value), "ranges": [value, {"after": b"x"}]}))
    assert back == {"": value, "ranges": [value, {"after": b"x"}]}
    assert list(map(type, back[""])) == list(map(type, value))
    assert math.copysign(1, back[""][1]) == -1
    assert math.isnan(Codec().read(encoded([math.nan] * 20))[19])


@pytest.mark.parametrize("dtype", ["<f4", ">f8", "i2", "?", "<u8"])
def test_arrays_of_numpy_come_back(dtype: str) -> None:
    value = np.arange(6).reshape(2, 3).astype(dtype)
    back = Codec().read(encoded({"array": value, "after": b"x"}))
    assert np.array_equal(back["array"], value)
    assert back["array"].flags.writeable
    assert back["after"] == b"x"


@pytest.mark.parametrize("value", [object(), [1, {2}], {"a": 1j}, array("u", "x"), np.array(["x"]), Point()])
def test_what_cannot_be_sent_is_named(value: Any) -> None:
    with pytest.raises(TypeError):
        Codec().write(value)


def test_a_long_integer_is_named() -> None:
    with pytest.raises(TypeError, match="an integer of some thousand digits"):
        encoded({"value": [10**5000]})


def test_what_is_sent_may_grow() -> None:
    codec = Codec(POINTS)
    kept = array("f", [1.0])
    parts = codec.write({"history": kept})
    kept.append(2.0)
    assert codec.read(b"".join(map(bytes, parts))) == {"history": array("f", [1.0])}


def test_messages_without_classes_come_back_as_objects_with_attributes() -> None:
    echo = PlainMessage("demo_msgs/Echo", {"distance": 1.5, "place": PlainMessage("Point", {"x": -2.0})})
    data = b"".join(map(bytes, Codec(PLAIN_OBJECTS).write([echo])))
    (read,) = Codec(PLAIN_OBJECTS).read(data)
    assert (read.distance, read.place.x) == (1.5, -2.0)
    with pytest.raises(AttributeError, match=r"^the message Point\(x=-2\.0\) of this call has no 'y'$"):
        _ = read.place.y
    assert copy.deepcopy(read).place.x == -2.0
    assert repr(read) == repr(echo) == "demo_msgs/Echo(distance=1.5, place=Point(x=-2.0))"
    with pytest.raises(MalformedError):
        Codec().read(data)


def test_what_contains_itself_cannot_be_sent() -> None:
    endless: dict[str, Any] = {}
    endless["self"] = [endless]
    with pytest.raises(TypeError, match="contains itself"):
        Codec().write(endless)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\x01\x00",
        head(""),
        head("nothing"),
        head("1 2"),
        head("[1"),
        head("[" * 100_000),
        head("\u00e9"),
        head("1", b"x"),
        head('{"": 1}'),
        head('{"": []}'),
        head('{"": "bytes"}'),
        head('{"": ["bytes", 1]}'),
        head('{"": ["bytes", -1]}', b"x"),
        head('{"": ["bytes", true]}', b"x"),
        head('{"": ["bytes", 1], "more": 2}', b"x"),
        head('{"": ["array", "u", 4]}', b"abcd"),
        head('{"": ["array", ["f"], 4]}', b"abcd"),
        head('{"": ["array", "f", 3]}', b"abc"),
        head('{"": ["floats", 12]}', b"abcdefghijkl"),
        head('{"": ["floats", 16]}', b"abcdefgh"),
        head('{"": ["floats", "8"]}', b"abcdefgh"),
        head('{"": ["numpy", "O", [1], 8]}', b"abcdefgh"),
        head('{"": ["numpy", ",8", [1], 8]}', b"abcdefgh"),
        head('{"": ["numpy", "<f4", [-1], 4]}', b"abcd"),
        head('{"": ["numpy", "<f4", [2], 4]}', b"abcd"),
        head('{"": [{"": ["numpy", "<f4", [1], 4]}, 1]}', b"abcd"),
        head('{"": ["dict", [[1, 2]]]}'),
        head('{"": ["dict", {"a": 1}]}'),
        head('{"": ["message", "Other", {}]}'),
        head('{"": ["message", 1, {}]}'),
        head('{"": ["message", "Point", [1]]}'),
        head('{"": ["code", "x"]}'),
    ],
)
def test_other_bytes_are_refused(data: bytes) -> None:
    codec = Codec()
    with pytest.raises(MalformedError):
        codec.read(data)
    assert codec.read(encoded({"a": b"x"})) == {"a": b"x"}  # and leave nothing


def test_any_bytes_are_a_value_or_refused() -> None:
    random_source = random.Random(8)
    samples = [
        encoded(["result", {"brake": 0.5, "ranges": array("f", [1.0, 2.0]), "": [b"x"]}, 3, 4]),
        encoded([Point(x=1, data=np.arange(3)), {"key": [1, "text"]}, [0.5] * 16]),
    ]
    codec = Codec(POINTS)
    refused = 0
    for _ in range(MUTANTS):
        data = bytearray(random_source.choice(samples))
        for _ in range(random_source.randint(1, 3)):
            position = random_source.randrange(len(data))
            data[position] = random_source.choice(b'\x00\xff[]{}",:019x' + bytes(samples[0]))
        try:
            codec.read(data)
        except MalformedError:
            refused += 1
    assert 0 < refused < MUTANTS
