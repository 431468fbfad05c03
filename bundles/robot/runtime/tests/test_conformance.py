"""The files in `messages/conformance`, against which the side in Java is tested, too."""

from __future__ import annotations

import json
from array import array
from typing import Any

import numpy as np
import pytest
from conftest import BUNDLE
from eventchain_ros2.catalog import Catalog
from eventchain_ros2.clock import Duration
from eventchain_ros2.definitions import Definition, resolved
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

FOLDER = BUNDLE.parent / "messages" / "conformance"
MESSAGES = [json.loads(line) for line in (FOLDER / "messages.jsonl").read_text(encoding="utf-8").splitlines()]
DEFINITIONS = json.loads((FOLDER / "definitions.json").read_text(encoding="utf-8"))
PAIRS = json.loads((FOLDER / "qos.json").read_text(encoding="utf-8"))
KINDS = {"reliability": ReliabilityPolicy, "durability": DurabilityPolicy, "liveliness": LivelinessPolicy}


@pytest.fixture(scope="module")
def own() -> Messages:
    return Messages([FOLDER / "definitions"])


@pytest.mark.parametrize("name", DEFINITIONS)
def test_definitions_are_resolved_as_in_java(own: Messages, name: str) -> None:
    found = own.catalog.find(name)
    assert found is not None
    expected = resolved(name, DEFINITIONS[name])
    assert repr(expected.fields) == repr(found.fields)  # as text, since nan is not equal to nan
    assert expected.constants == found.constants


def plain(value: Any) -> Any:
    """A value as the file has it."""
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
    message_class = own.get(line["type"])
    data = bytes.fromhex(line["cdr"])
    message = from_cdr(message_class, data)
    assert plain(message) == line["value"]
    assert to_cdr(message) == data
    assert plain(from_cdr(message_class, bytes.fromhex(line["cdr_big_endian"]))) == line["value"]


@pytest.mark.parametrize(("name", "expected"), {line["type"]: line["hash"] for line in MESSAGES}.items())
def test_types_have_their_hashes(own: Messages, name: str, expected: str) -> None:
    def defined(each: str, catalog: Catalog = own.catalog) -> Definition:
        found = catalog.find(each)
        assert found is not None
        return found

    assert type_hash(name, defined) == expected


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
