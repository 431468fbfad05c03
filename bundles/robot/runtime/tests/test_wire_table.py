"""The facts about DDS in `messages/conformance/wire.json`, which are also tested in Java."""

from __future__ import annotations

from typing import Any

import pytest
from eventchain_ros2 import graph
from eventchain_ros2.dds_entities import HIGHEST_DOMAIN, Participant
from eventchain_ros2.definitions import message_name
from eventchain_ros2.graph import GraphNode
from eventchain_ros2.type_support import dds_type_name
from wire import TABLE, fresh_tag, loopback_configuration


def in_distribution(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    if name:
        monkeypatch.setenv("ROS_DISTRO", name)


def test_the_highest_domain_can_be_used() -> None:
    assert TABLE["highest_domain"] == HIGHEST_DOMAIN
    Participant(HIGHEST_DOMAIN, loopback_configuration(fresh_tag())).close()


@pytest.mark.parametrize(("distribution", "size"), TABLE["identifier_bytes"].items())
def test_identifiers_have_the_size_of_the_distribution(
    monkeypatch: pytest.MonkeyPatch, distribution: str, size: int
) -> None:
    in_distribution(monkeypatch, distribution)
    assert graph.gid_size() == size


@pytest.mark.parametrize("row", TABLE["graph"], ids=lambda row: row["distribution"])
def test_nodes_are_told_in_the_bytes_of_the_distribution(monkeypatch: pytest.MonkeyPatch, row: dict[str, Any]) -> None:
    in_distribution(monkeypatch, row["distribution"])
    writers, readers = (tuple(bytes.fromhex(each) for each in row[kind]) for kind in ("writers", "readers"))
    participant = bytes.fromhex(row["participant"])
    node = GraphNode(row["node"], "/", participant, writers, readers)
    data = bytes.fromhex(row["cdr"])
    assert graph.encode(participant, [node], graph.gid_size()) == data
    assert graph.decode(data, graph.gid_size()) == [node]


@pytest.mark.parametrize("row", TABLE["types"], ids=lambda row: row["ros"])
def test_types_have_their_names_on_the_wire(row: dict[str, str]) -> None:
    assert dds_type_name(row["ros"]) == row["dds"]
    assert message_name(row["dds"]) == row["ros"]
