"""The files in `messages/conformance`, which are also tested in Java."""

from __future__ import annotations

import json
from array import array
from typing import Any

import numpy as np
import pytest
from eventchain_ros2.catalog import read
from eventchain_ros2.clock import Duration
from eventchain_ros2.definitions import Definition
from eventchain_ros2.messages import Message, Messages, from_cdr, to_cdr
from eventchain_ros2.qos import (
    DurabilityPolicy,
    LivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    incompatible_policies,
)
from eventchain_ros2.type_support import type_hash
from wire import CONFORMANCE, DEFINITIONS

MESSAGES, MESSAGES_OF_JAZZY = (
    [json.loads(line) for line in (CONFORMANCE / name).read_text(encoding="utf-8").splitlines()]
    for name in ("messages.jsonl", "jazzy.jsonl")
)
OF_CHARACTERS = ("rmw_dds_common/msg/Gid", "service_msgs/msg/ServiceEventInfo")  # uint8 in ROS 2, not so in rosbags
HASHES = {line["type"]: line["hash"] for line in MESSAGES}
HASHES_OF_JAZZY = {line["type"]: line["hash"] for line in MESSAGES_OF_JAZZY if line["type"] not in OF_CHARACTERS}
PAIRS = json.loads((CONFORMANCE / "qos.json").read_text(encoding="utf-8"))
KINDS = {"reliability": ReliabilityPolicy, "durability": DurabilityPolicy, "liveliness": LivelinessPolicy}


@pytest.fixture(scope="module")
def own() -> Messages:
    return Messages(read([DEFINITIONS]))


@pytest.fixture(scope="module")
def jazzy() -> Messages:
    return Messages(read([CONFORMANCE / "jazzy.json"]))


def test_values_are_those_of_the_definitions(own: Messages) -> None:
    """Bytes of `kinds_msgs/msg/Values` and `radar_msgs/msg/Target` in each representation that there is."""
    values: Any = own.get("kinds_msgs/msg/Values")
    assert values.EQUAL == "a = b"
    assert plain(values()) == {
        "ten": 10,
        "most": 255,
        "grouped": 1000,
        "binary": -5,
        "nothing": "nan",
        "endless": ["inf", "-inf", "10.5"],
        "whole": "7.0",
        "fits": "a\"b'c",
        "bare": 'it is "so"',
        "empty": "",
        "texts": ["a, b", 'c "d"', "e f"],
        "off": False,
        "letter": 65,
        "largest": 18446744073709551615,
        "smallest": -9223372036854775808,
        "bytes": [0, 255],
        "words": [65535, 16],
        "numbers": ["0.5", "nan", "1000.0"],
        "flags": [True, False],
        "octets": [128],
    }
    target: Any = own.get("radar_msgs/msg/Target")
    assert (target.LIMIT, target.MASK, target.RANGE, target.IS_NEW, target.NAME) == (-7, 31, 150.0, True, "a name\n")
    assert (target().speed, target().seen, target().name) == (-2.5, True, 'no "name"')
    assert target().codes == array("h", [1, 2, 3])


def test_messages_in_idl_can_be_imported(own: Messages) -> None:
    own.install()
    from radar_msgs.msg import Nothing, Scan, Target

    assert isinstance(Scan().nearest, Target)
    assert Nothing.get_fields_and_field_types() == {}


def plain(value: Any) -> Any:
    """Return a value as in the file."""
    if isinstance(value, Message):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    if isinstance(value, np.ndarray | array | list):
        return [plain(item) for item in value]
    if isinstance(value, bytes):
        return value[0]
    if isinstance(value, np.generic):
        return plain(value.item())
    return repr(value) if isinstance(value, float) else value


@pytest.mark.parametrize("line", MESSAGES, ids=lambda line: line["type"])
def test_messages_have_their_bytes(own: Messages, line: dict[str, Any]) -> None:
    assert_has_its_bytes(own, line)


@pytest.mark.parametrize("line", MESSAGES_OF_JAZZY, ids=lambda line: line["type"])
def test_messages_of_jazzy_have_their_bytes(jazzy: Messages, line: dict[str, Any]) -> None:
    assert_has_its_bytes(jazzy, line)


def assert_has_its_bytes(messages: Messages, line: dict[str, Any]) -> None:
    message_class = messages.get(line["type"])
    data = bytes.fromhex(line["cdr"])
    message = from_cdr(message_class, data)
    assert plain(message) == line["value"]
    assert to_cdr(message) == data
    assert plain(from_cdr(message_class, bytes.fromhex(line["cdr_big_endian"]))) == line["value"]


@pytest.mark.parametrize(("name", "expected"), HASHES.items())
def test_types_have_their_hashes(own: Messages, name: str, expected: str) -> None:
    assert hash_of(name, own) == expected


@pytest.mark.parametrize(("name", "expected"), HASHES_OF_JAZZY.items())
def test_types_of_jazzy_have_their_hashes(jazzy: Messages, name: str, expected: str) -> None:
    assert hash_of(name, jazzy) == expected


def hash_of(name: str, messages: Messages) -> str:
    def defined(each: str) -> Definition:
        found = messages.catalog.find(each)
        assert found is not None
        return found

    return type_hash(name, defined)


def profile(stated: dict[str, Any]) -> QoSProfile:
    made = QoSPresetProfiles.get_from_short_key(stated.get("profile", "default"))
    policies = {name: getattr(made, name) for name in ("history", "depth", *KINDS)}
    policies.update({name: kinds[stated[name]] for name, kinds in KINDS.items() if name in stated})
    policies["deadline"] = Duration(nanoseconds=stated.get("deadline_ns", 0))
    policies["liveliness_lease_duration"] = Duration(nanoseconds=stated.get("lease_ns", 0))
    return QoSProfile(**policies)


@pytest.mark.parametrize("pair", PAIRS, ids=str)
def test_offers_satisfy_requests_or_not(pair: dict[str, Any]) -> None:
    found = list(incompatible_policies(profile(pair["offered"]), profile(pair["requested"])))
    assert found == pair["incompatible"]
