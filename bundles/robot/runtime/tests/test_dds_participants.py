"""Participants on the wire: their domains, their library, their nodes, and other processes."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from time import sleep

import pytest
from conftest import BUNDLE, FIXTURES
from eventchain_ros2 import cyclone
from eventchain_ros2.cyclone import DdsError
from eventchain_ros2.dds_entities import ClosedError, Participant, WaitSet
from instances import STORE, random_message
from wire import (
    DOMAIN,
    EVERY,
    LATEST,
    PATIENCE,
    SCAN,
    STRING,
    TEXT,
    connected,
    fresh_tag,
    loopback_configuration,
    reach_echo,
    take,
    wait_until,
)


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


def echo(configuration: str, type_name: str) -> subprocess.Popen[bytes]:
    paths = f"{BUNDLE / 'python'}"
    script = str(FIXTURES / "wire" / "echo.py")
    environment = {**os.environ, "PYTHONPATH": paths}
    return subprocess.Popen([sys.executable, script, str(DOMAIN), configuration, type_name], env=environment)


@pytest.mark.parametrize("name", [STRING, SCAN, "std_msgs/msg/Empty", "nav_msgs/msg/Odometry", "sensor_msgs/msg/Image"])
def test_bytes_and_timestamps_survive_the_way_to_another_process_and_back(name: str) -> None:
    configuration = loopback_configuration(fresh_tag())
    generator = random.Random(name)
    samples = [bytes(STORE.serialize_cdr(random_message(name, generator), name)) for _ in range(50)]
    with Participant(DOMAIN, configuration) as participant:
        writer = participant.writer("/there", name, EVERY)
        reader = participant.reader("/back", name, EVERY)
        process = echo(configuration, name)
        reach_echo(writer, reader, samples[0])
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
    own, other = loopback_configuration(fresh_tag()), loopback_configuration(fresh_tag())
    with Participant(DOMAIN, own) as participant:
        writer = participant.writer("/there", STRING, EVERY)
        stranger, friend = echo(other, STRING), echo(own, STRING)
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
