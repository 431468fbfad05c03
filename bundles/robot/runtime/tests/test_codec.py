"""The generated codecs compared with rosbags, an independent implementation."""

from __future__ import annotations

import random
from array import array
from typing import Any

import numpy as np
import pytest
from eventchain_ros2.messages import MalformedMessageError, Message, Messages, from_cdr, to_cdr
from instances import PLACEHOLDER, STORE, random_message
from rosbags.typesys import get_types_from_msg

INSTANCES = 20
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


def plain(value: Any) -> Any:
    """Return a value of either implementation in a common form."""
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
        data = bytes(STORE.serialize_cdr(theirs, name))
        ours = from_cdr(messages.get(name), data)
        assert plain(ours) == plain(theirs)
        assert to_cdr(ours) == data
        swapped = bytes(STORE.serialize_cdr(theirs, name, little_endian=False))
        assert swapped[:2] == b"\0\0"
        assert to_cdr(from_cdr(messages.get(name), swapped)) == data, "the same message in the other byte order"


@pytest.mark.parametrize("name", sorted(STORE.fielddefs))
def test_standard_messages_are_encoded_as_rosbags_encodes_them(messages: Messages, name: str) -> None:
    assert_agreement(messages, name)


def test_every_kind_of_field_is_encoded_as_rosbags_encodes_it() -> None:
    fields = [line.split()[::-1] for line in EXOTIC.replace("/", "/msg/").split("\n") if line]
    exotic = {"exotic_msgs/msg/Exotic": {"fields": fields, "constants": []}}
    STORE.register(get_types_from_msg(EXOTIC, "exotic_msgs/msg/Exotic"))
    for _ in range(20):
        assert_agreement(Messages(exotic), "exotic_msgs/msg/Exotic")


def test_the_packaged_definitions_are_those_of_rosbags() -> None:
    from extract_standard_messages import FOLDER, files

    for name, content in files().items():
        assert (FOLDER / name).read_text(encoding="utf-8") == content


@pytest.mark.parametrize("little_endian", [True, False])
def test_truncated_bytes_are_refused_at_every_length(messages: Messages, little_endian: bool) -> None:
    scan: Any = messages.get("sensor_msgs/msg/LaserScan")
    theirs = STORE.deserialize_cdr(bytes(to_cdr(scan(ranges=[1.0, 2.0]))), "sensor_msgs/msg/LaserScan")
    data = bytes(STORE.serialize_cdr(theirs, "sensor_msgs/msg/LaserScan", little_endian=little_endian))
    for length in range(len(data)):
        with pytest.raises(MalformedMessageError):
            from_cdr(scan, data[:length])


@pytest.mark.parametrize("header", [b"\0\2", b"\0\3", b"\0\6", b"\0\7", b"\1\1"])
def test_other_encodings_than_plain_cdr_are_refused(messages: Messages, header: bytes) -> None:
    with pytest.raises(MalformedMessageError, match="only plain CDR"):
        from_cdr(messages.get("std_msgs/msg/Float32"), header + bytes(6))
