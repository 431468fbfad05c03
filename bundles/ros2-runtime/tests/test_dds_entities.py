"""Participants on the wire, within one process and between two."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from time import monotonic_ns, sleep
from typing import Any

import pytest
from conftest import BUNDLE, FIXTURES
from eventchain_ros2 import cyclone
from eventchain_ros2.clock import Duration
from eventchain_ros2.cyclone import DdsError
from eventchain_ros2.dds_entities import (
    ClosedError,
    Participant,
    Reader,
    Received,
    WaitSet,
    Writer,
    loopback_configuration,
)
from eventchain_ros2.definitions import Catalog
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from instances import STORE, random_message
from wire import DOMAIN, PATIENCE, fresh_tag, wait_until

MILLISECOND = 1_000_000
SECOND = 1_000 * MILLISECOND
LATEST = (2**32 - 1) * SECOND - 1
STRING, SCAN = "std_msgs/msg/String", "sensor_msgs/msg/LaserScan"
EVERY = QoSProfile(history=HistoryPolicy.KEEP_ALL)
BEST_EFFORT = ReliabilityPolicy.BEST_EFFORT
TEXT = b"\0\1\0\0\2\0\0\0x\0"


@pytest.fixture
def participants() -> Iterator[tuple[Participant, Participant]]:
    configuration = loopback_configuration(fresh_tag())
    with Participant(DOMAIN, configuration) as one, Participant(DOMAIN, configuration) as other:
        yield one, other


def connected(
    participants: tuple[Participant, Participant], type_name: str = STRING, profile: QoSProfile = EVERY
) -> tuple[Writer, Reader]:
    writer = participants[0].writer("/topic", type_name, profile)
    reader = participants[1].reader("/topic", type_name, profile)
    wait_until(lambda: writer.matched() and reader.matched(), "a match")
    return writer, reader


def take(reader: Reader, count: int) -> list[Received]:
    taken: list[Received] = []
    wait_until(lambda: taken.extend(reader.take()) or len(taken) >= count, f"{count} samples")
    return taken


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
    from time import time_ns

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


@pytest.mark.parametrize(
    ("offered", "requested", "policy"),
    [
        ({"reliability": BEST_EFFORT}, {}, "RELIABILITY"),
        ({}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "DURABILITY"),
        ({"deadline": Duration(seconds=2)}, {"deadline": Duration(seconds=1)}, "DEADLINE"),
        ({}, {"deadline": Duration(seconds=1)}, "DEADLINE"),
        ({}, {"liveliness": LivelinessPolicy.MANUAL_BY_TOPIC}, "LIVELINESS"),
        ({}, {"liveliness_lease_duration": Duration(seconds=9)}, "LIVELINESS"),
    ],
)
def test_both_sides_know_the_policy_that_does_not_match(
    participants: tuple[Participant, Participant], offered: dict[str, Any], requested: dict[str, Any], policy: str
) -> None:
    writer = participants[0].writer("/topic", STRING, QoSProfile(depth=1, **offered))
    waiting = WaitSet(participants[1])
    reader = participants[1].reader("/topic", STRING, QoSProfile(depth=1, **requested))
    waiting.attach_events(reader)
    assert waiting.wait(PATIENCE * SECOND)
    assert reader.incompatible() == policy
    assert reader.incompatible() is None
    names: list[str | None] = []
    wait_until(lambda: names.append(writer.incompatible()) or names[-1], "the writer's side")
    assert names[-1] == policy
    assert (writer.matched(), reader.matched()) == (0, 0)


def test_matching_policies_are_no_event(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    assert (writer.incompatible(), reader.incompatible()) == (None, None)
    assert (writer.missed_deadlines(), reader.missed_deadlines()) == (0, 0)
    assert (writer.lost_liveliness(), reader.lost_writers()) == (0, 0)


def test_both_sides_know_of_a_missed_deadline(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants, profile=QoSProfile(depth=1, deadline=Duration(seconds=0.05)))
    writer.write(TEXT)
    missed = [0, 0]

    def both_missed() -> bool:
        missed[0] += writer.missed_deadlines()
        missed[1] += reader.missed_deadlines()
        return all(missed)

    wait_until(both_missed, "missed deadlines")


def test_both_sides_know_of_a_writer_that_does_not_show_up(participants: tuple[Participant, Participant]) -> None:
    manual = LivelinessPolicy.MANUAL_BY_TOPIC
    lease = Duration(seconds=0.05)
    profile = QoSProfile(depth=1, liveliness=manual, liveliness_lease_duration=lease)
    writer, reader = connected(participants, profile=profile)
    writer.write(TEXT)
    lost = [0, 0]

    def both_lost() -> bool:
        lost[0] += writer.lost_liveliness()
        lost[1] += reader.lost_writers()
        return all(lost)

    wait_until(both_lost, "lost liveliness")


def test_a_wait_ends_with_a_sample_or_with_the_time(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    waiting = WaitSet(participants[1])
    waiting.attach(reader)
    started = monotonic_ns()
    assert not waiting.wait(250 * MILLISECOND)
    assert monotonic_ns() - started >= 250 * MILLISECOND
    writer.write(TEXT, 1)
    assert waiting.wait(PATIENCE * SECOND)
    assert waiting.wait(0), "until it is taken"
    reader.take()
    assert not waiting.wait(0)


def test_a_wait_can_be_ended_from_another_thread(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    thread = threading.Timer(0.3, waiting.wake)
    thread.start()
    assert waiting.wait(None)
    thread.join()
    assert not waiting.wait(0), "once only"


def test_a_wait_lets_signal_handlers_run(participants: tuple[Participant, Participant]) -> None:
    def interrupt(*_: object) -> None:
        raise InterruptedError

    former = signal.signal(signal.SIGUSR1, interrupt)
    thread = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGUSR1))
    try:
        thread.start()
        with pytest.raises(InterruptedError):
            WaitSet(participants[0]).wait(None)
    finally:
        thread.join()
        signal.signal(signal.SIGUSR1, former)


def test_a_signal_handler_can_end_the_wait_it_interrupts(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    former = signal.signal(signal.SIGUSR1, lambda *_: waiting.wake())
    thread = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGUSR1))
    try:
        thread.start()
        assert waiting.wait(PATIENCE * SECOND)
    finally:
        thread.join()
        signal.signal(signal.SIGUSR1, former)


def test_closing_ends_a_wait(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    thread = threading.Timer(0.3, participants[0].close)
    thread.start()
    with pytest.raises(ClosedError):
        waiting.wait(None)
    thread.join()


def test_what_is_closed_refuses_everything(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    waiting, other = WaitSet(participants[0]), participants[1].reader("/other", STRING, EVERY)
    other.close()
    other.close()
    with pytest.raises(ClosedError, match="the reader of /other is closed"):
        other.take()
    participants[0].close()
    participants[0].close()
    writer.close()
    for refused in (
        lambda: writer.write(TEXT, 1),
        writer.matched,
        writer.peers,
        writer.incompatible,
        writer.missed_deadlines,
        writer.lost_liveliness,
        writer.assert_liveliness,
        lambda: writer.wait_for_acknowledgments(0),
        lambda: waiting.wait(0),
        waiting.wake,
        lambda: waiting.attach(other),
        lambda: participants[0].writer("/topic", STRING, EVERY),
        lambda: participants[0].reader("/topic", STRING, EVERY),
        lambda: participants[0].announce("node", "/", [], []),
        participants[0].nodes,
    ):
        with pytest.raises(ClosedError):
            refused()  # type: ignore[operator]
    wait_until(lambda: reader.matched() == 0, "the writer to be gone")


def test_a_type_that_is_not_defined_is_refused(participants: tuple[Participant, Participant]) -> None:
    with pytest.raises(KeyError, match="no_msgs/msg/None"):
        participants[0].writer("/topic", "no_msgs/msg/None", EVERY)


@pytest.mark.parametrize("domain", [-1, 233])
def test_a_number_that_is_no_domain_is_refused(domain: int) -> None:
    with pytest.raises(ValueError, match="not the number of a domain"):
        Participant(domain, loopback_configuration("tag"))


def test_a_configuration_that_is_none_is_refused_and_the_domain_stays_free() -> None:
    with pytest.raises(DdsError):
        Participant(DOMAIN, "<CycloneDDS><Domain><NoSuch/></Domain></CycloneDDS>")
    Participant(DOMAIN, loopback_configuration(fresh_tag())).close()


def test_one_process_has_one_configuration_of_a_domain(participants: tuple[Participant, Participant]) -> None:
    with pytest.raises(ValueError, match="another configuration"):
        Participant(DOMAIN, loopback_configuration("another"))


def test_another_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("EVENTCHAIN_LIBDDSC", "/no/such/libddsc.so")
    cyclone.load.cache_clear()
    try:
        with pytest.raises(cyclone.LibraryUnavailableError, match=r"/no/such/libddsc\.so") as raised:
            cyclone.load()
        assert "11.0.1" in raised.value.hint
        monkeypatch.setenv("EVENTCHAIN_LIBDDSC", "libm.so.6")
        with pytest.raises(cyclone.LibraryUnavailableError, match="has no function"):
            cyclone.load()
    finally:
        monkeypatch.undo()
        cyclone.load.cache_clear()


def echo(tag: str, type_name: str) -> subprocess.Popen[bytes]:
    paths = f"{BUNDLE / 'python'}"
    script = str(FIXTURES / "wire" / "echo.py")
    environment = {**os.environ, "PYTHONPATH": paths}
    return subprocess.Popen([sys.executable, script, str(DOMAIN), tag, type_name], env=environment)


@pytest.mark.parametrize("name", [STRING, SCAN, "std_msgs/msg/Empty", "nav_msgs/msg/Odometry", "sensor_msgs/msg/Image"])
def test_bytes_and_timestamps_survive_the_way_to_another_process_and_back(name: str) -> None:
    tag = fresh_tag()
    generator = random.Random(name)
    samples = [bytes(STORE.serialize_cdr(random_message(name, generator), name)) for _ in range(50)]
    with Participant(DOMAIN, loopback_configuration(tag)) as participant:
        writer = participant.writer("/there", name, EVERY)
        reader = participant.reader("/back", name, EVERY)
        process = echo(tag, name)
        wait_until(lambda: writer.matched() and reader.matched(), "the other process")
        timestamps = [0, 1, LATEST, *(generator.randrange(LATEST) for _ in samples[3:])]
        written = list(zip(timestamps, samples, strict=True))
        for timestamp, sample in written:
            writer.write(sample, timestamp)
        received = take(reader, len(samples))
        assert [(each.source_timestamp, each.data) for each in received] == written
        wait_until(lambda: participant.nodes(), "the other's node")
        (node,) = participant.nodes()
        assert (node.name, node.namespace) == ("echo", "/far")
        assert node.writers == (reader.peers()[0].guid,)
        assert node.readers == (writer.peers()[0].guid,)
    assert process.wait(PATIENCE) == 0, "it has seen that the others are gone"


def test_participants_with_another_tag_do_not_meet() -> None:
    tag, other = fresh_tag(), fresh_tag()
    with Participant(DOMAIN, loopback_configuration(tag)) as participant:
        writer = participant.writer("/there", STRING, EVERY)
        stranger, friend = echo(other, STRING), echo(tag, STRING)
        try:
            wait_until(lambda: writer.matched(), "the process of this tag")
            sleep(1)  # the stranger has had its time as well
            assert writer.matched() == 1
        finally:
            stranger.kill()
            stranger.wait()
    assert friend.wait(PATIENCE) == 0


def test_the_node_of_a_process_that_dies_leaves_the_graph(participants: tuple[Participant, Participant]) -> None:
    one, other = participants
    writer, reader = connected(participants)
    one.announce("talker", "/", [writer], [])
    other.announce("listener", "/", [], [reader])
    one.announce("second", "/room", [], [])
    wait_until(lambda: len(other.nodes()) == 2, "both nodes")
    assert [(node.name, node.namespace, node.writers) for node in other.nodes()] == [
        ("second", "/room", ()),
        ("talker", "/", (writer.guid,)),
    ]
    wait_until(lambda: [node.name for node in one.nodes()] == ["listener"], "the node of the other")
    one.close()
    wait_until(lambda: not other.nodes(), "the nodes to be gone")
