"""The generated codecs against an independent implementation, that of rosbags."""

from __future__ import annotations

import random
import string
from array import array
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from eventchain_ros2.definitions import STANDARD_MESSAGES
from eventchain_ros2.messages import MalformedMessageError, Message, Messages, from_cdr, to_cdr
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

STORE = get_typestore(Stores.ROS2_HUMBLE)
INSTANCES = 4
PLACEHOLDER = "structure_needs_at_least_one_member"
EXOTIC = """
bool[] flags
bool[3] three_flags
byte[] octets
byte[2] two_octets
int8 small
float64[2] pair
string[] words
string[2] two_words
string<=5 short
uint8[3] bytes_of_three
int64[<=2] numbers
geometry_msgs/Point32[2] points
char letter
uint64 large
"""


def random_value(description: Any, generator: random.Random) -> Any:
    kind, detail = description
    if kind == Nodetype.NAME:
        return random_message(detail, generator)
    if kind == Nodetype.BASE:
        return random_primitive(detail[0], generator, detail[1])
    element, bound = detail
    count = bound if kind == Nodetype.ARRAY else generator.randrange(min(bound or 4, 4) + 1)
    values = [random_value(element, generator) for _ in range(count)]
    if element[0] == Nodetype.BASE and element[1][0] != "string":
        return np.array(
            values, dtype=np.dtype({"bool": "?", "byte": "u1", "char": "u1"}.get(element[1][0], element[1][0]))
        )
    return values


def random_primitive(base: str, generator: random.Random, bound: int) -> Any:
    if base == "string":
        return "".join(generator.choices(string.ascii_letters + "äß€", k=generator.randrange(bound or 8) // 3))
    if base == "bool":
        return generator.random() < 0.5
    if base.startswith("float"):
        return float(np.float32(generator.choice([generator.uniform(-1e6, 1e6), float("inf"), 0.0])))
    if base in ("byte", "char"):
        return generator.randrange(128)  # rosbags takes a byte for an int8
    bits = int(base.lstrip("uint"))
    low = 0 if base.startswith("u") else -(2 ** (bits - 1))
    return generator.randrange(low, low + 2**bits)


def random_message(name: str, generator: random.Random) -> Any:
    values = {field: random_value(description, generator) for field, description in STORE.fielddefs[name][1]}
    return STORE.types[name](**values)


def plain(value: Any) -> Any:
    """A value of either implementation in one form."""
    if isinstance(value, bytes):
        return value[0]
    if isinstance(value, np.ndarray | array | list):
        return [plain(item) for item in value]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Message):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    if hasattr(value, "__msgtype__"):
        names = [name for name, _ in STORE.fielddefs[value.__msgtype__][1]]
        return {name: plain(getattr(value, name)) for name in names if name != PLACEHOLDER}
    return value


def assert_agreement(messages: Messages, name: str) -> None:
    generator = random.Random(name)
    for _ in range(INSTANCES):
        theirs = random_message(name, generator)
        if hasattr(theirs, PLACEHOLDER):
            theirs = replace(theirs, **{PLACEHOLDER: 0})
        data = bytes(STORE.serialize_cdr(theirs, name))
        ours = from_cdr(messages.get(name), data)
        assert plain(ours) == plain(theirs)
        assert to_cdr(ours) == data


@pytest.mark.parametrize("name", sorted(STORE.fielddefs))
def test_standard_messages_are_encoded_as_rosbags_encodes_them(messages: Messages, name: str) -> None:
    assert_agreement(messages, name)


def test_every_kind_of_field_is_encoded_as_rosbags_encodes_it(tmp_path: Any) -> None:
    file = tmp_path / "exotic_msgs" / "msg" / "Exotic.msg"
    file.parent.mkdir(parents=True)
    file.write_text(EXOTIC)
    STORE.register(get_types_from_msg(EXOTIC, "exotic_msgs/msg/Exotic"))
    for _ in range(20):
        assert_agreement(Messages([tmp_path]), "exotic_msgs/msg/Exotic")


def test_the_packaged_definitions_are_those_of_rosbags() -> None:
    from extract_standard_messages import definitions

    assert STANDARD_MESSAGES.read_text(encoding="utf-8") == definitions()


def test_truncated_bytes_are_refused_at_every_length(messages: Messages) -> None:
    scan = messages.get("sensor_msgs/msg/LaserScan")
    data = to_cdr(scan(ranges=[1.0, 2.0]))
    for length in range(len(data)):
        with pytest.raises(MalformedMessageError):
            from_cdr(scan, data[:length])


def test_big_endian_bytes_are_refused(messages: Messages) -> None:
    with pytest.raises(MalformedMessageError, match="little-endian"):
        from_cdr(messages.get("std_msgs/msg/Float32"), b"\0\0\0\0" + bytes(4))
