"""Samples on the wire, and those that are refused or kept."""

from __future__ import annotations

import random
from time import time_ns

import pytest
from eventchain_ros2.catalog import Catalog
from eventchain_ros2.dds_entities import Participant
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.qos import DurabilityPolicy, QoSProfile
from instances import STORE, random_message
from wire import (
    DOMAIN,
    LATEST,
    PATIENCE,
    SCAN,
    SECOND,
    STRING,
    TEXT,
    connected,
    fresh_tag,
    loopback_configuration,
    take,
    wait_until,
)


def test_a_sample_arrives_with_the_timestamp_and_the_writer_it_was_written_with(
    participants: tuple[Participant, Participant],
) -> None:
    writer, reader = connected(participants)
    for timestamp in (0, 7, LATEST):
        writer.write(TEXT, timestamp)
    received = take(reader, 3)
    assert [(each.source_timestamp, each.data) for each in received] == [(0, TEXT), (7, TEXT), (LATEST, TEXT)]
    (peer,) = reader.peers()
    assert {each.publication for each in received} == {peer.handle}
    assert peer.guid == writer.guid
    assert [each.guid for each in writer.peers()] == [reader.guid]


def test_without_a_timestamp_it_is_the_time_on_the_clock(participants: tuple[Participant, Participant]) -> None:

    writer, reader = connected(participants)
    before = time_ns()
    writer.write(TEXT)
    (received,) = take(reader, 1)
    assert before <= received.source_timestamp <= time_ns()


def test_more_samples_than_one_call_takes_arrive_in_order(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    for index in range(500):
        writer.write(TEXT, index)
    assert [each.source_timestamp for each in take(reader, 500)] == list(range(500))
    assert reader.take() == []


@pytest.mark.parametrize("name", sorted(Catalog().names()))
def test_every_standard_type_is_a_topic(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setenv("ROS_DISTRO", "humble")  # the standard types are those of Humble
    configuration = loopback_configuration(fresh_tag())
    with Participant(DOMAIN, configuration) as one, Participant(DOMAIN, configuration) as other:
        writer, reader = connected((one, other), name)
        generator = random.Random(name)
        samples = [bytes(STORE.serialize_cdr(random_message(name, generator), name)) for _ in range(3)]
        for sample in samples:
            writer.write(sample, 1)
        assert [each.data for each in take(reader, 3)] == samples


def test_names_on_the_wire_are_those_of_ros(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants, SCAN)
    (peer,) = reader.peers()
    assert peer.type_name == "sensor_msgs::msg::dds_::LaserScan_"
    assert peer.type_hash == writer.type_hash
    assert peer.type_hash.startswith("RIHS01_")
    plain = QoSProfile(depth=1, avoid_ros_namespace_conventions=True)
    by_wire_name = participants[1].reader("rt/topic", SCAN, plain)
    wait_until(lambda: by_wire_name.matched() == 1, "a match by the name on the wire")


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\0\1",
        b"\0\1\0\0",
        TEXT[:-1],
        b"\0\1\0\0\xff\xff\xff\xffx\0",
        b"\0\1\0\0\0\0\0\0",
        b"\0\7\0\0" + bytes(8),
        b"\0\3\0\0" + bytes(8),
    ],
)
def test_bytes_that_are_no_encoding_of_the_type_are_refused(
    participants: tuple[Participant, Participant], data: bytes
) -> None:
    writer, reader = connected(participants)
    for timestamp in (None, 1):
        with pytest.raises(ValueError, match="/topic"):
            writer.write(data, timestamp)
    writer.write(TEXT, 1)
    assert [each.data for each in take(reader, 1)] == [TEXT]


def test_a_sample_cut_short_anywhere_is_refused(participants: tuple[Participant, Participant]) -> None:
    writer, _ = connected(participants, SCAN)
    data = bytes(STORE.serialize_cdr(random_message(SCAN, random.Random(1)), SCAN))
    for length in range(len(data)):
        with pytest.raises(ValueError, match="/topic"):
            writer.write(data[:length], 1)


@pytest.mark.parametrize("timestamp", [-1, LATEST + 1, 2**63 - 1, -(2**63)])
def test_a_timestamp_out_of_range_is_refused(participants: tuple[Participant, Participant], timestamp: int) -> None:
    with pytest.raises(ValueError, match="not a source timestamp"):
        connected(participants)[0].write(TEXT, timestamp)


def test_big_endian_samples_arrive(participants: tuple[Participant, Participant], messages: Messages) -> None:
    writer, reader = connected(participants, SCAN)
    theirs = random_message(SCAN, random.Random(2))
    writer.write(bytes(STORE.serialize_cdr(theirs, SCAN, little_endian=False)), 1)
    (received,) = take(reader, 1)
    expected = bytes(STORE.serialize_cdr(theirs, SCAN))
    assert to_cdr(from_cdr(messages.get(SCAN), received.data)) == expected


def test_only_the_last_samples_are_kept(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants, profile=QoSProfile(depth=2))
    for index in range(5):
        writer.write(TEXT, index)
    assert writer.wait_for_acknowledgments(PATIENCE * SECOND)
    assert [each.source_timestamp for each in reader.take()] == [3, 4]


def test_a_reader_that_joins_late_gets_what_is_retained(participants: tuple[Participant, Participant]) -> None:
    retained = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    writer = participants[0].writer("/topic", STRING, retained)
    for index in range(4):
        writer.write(TEXT, index)
    late = participants[1].reader("/topic", STRING, retained)
    assert [each.source_timestamp for each in take(late, 2)] == [2, 3]
