"""The host of one node on the wire: real pipes, real DDS, confined as in the product, but without bubblewrap."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from pathlib import Path
from time import monotonic_ns
from typing import Any

import pytest
from eventchain_ros2.dds_entities import Participant, Reader, Writer
from eventchain_ros2.qos import QoSProfile
from protocol import (
    CONFIGURE,
    CONNECT,
    CONNECTED,
    FINISH,
    FINISHED,
    IDLE,
    MILLISECOND,
    PUBLISH,
    RESET,
    RUN,
    START,
    STOP,
    Failed,
    HostProcess,
    doubler,
    float32,
)
from wire import DOMAIN, fresh_tag, loopback_configuration, wait_until

FIXTURES = Path(__file__).with_name("fixtures")
PERIOD = 50 * MILLISECOND


class NodeProcess(HostProcess):
    """A host on the wire."""

    module = "eventchain_ros2.node_host"

    def __init__(self, tag: str) -> None:
        settings = {"domain": DOMAIN, "configuration": loopback_configuration(tag), "messages": []}
        self.preparation = {"module": "eventchain_ros2.preparation", "settings": settings}
        super().__init__()

    def join(self, world: World, configuration: dict[str, Any], kind: int = CONFIGURE, **more: Any) -> list[Any]:
        """Configure it, and wait until it and the world have found each other; return what is missing."""
        ready = self.configure(configuration, kind=kind)
        missing = self.connect(world, **more)
        (writer,), (reader,) = ready["writers"], ready["readers"]
        for end, peer in (
            (world.number, reader["guid"]),
            (world.doubled, writer["guid"]),
            (world.clock, ready["clock"]),
        ):
            wait_until(lambda end=end, peer=peer: peer in {each.guid.hex() for each in end.peers()}, end.topic)
        return missing

    def connect(
        self, world: World, *, turn: tuple[int, int] = (0, 1), others: tuple[str, ...] = (), timeout: float = 60.0
    ) -> list[Any]:
        sinks, sources = [world.doubled.guid.hex(), *others], [world.number.guid.hex()]
        wanted = {"writers": [sinks], "turns": [turn], "readers": [sources], "timeout_s": timeout}
        self.send(CONNECT, json.dumps(wanted).encode())
        missing: list[Any] = json.loads(self.receive(CONNECTED))["missing"]
        return missing

    def let(self, kind: int, time: int) -> Any:
        """Let it publish or run; return its report."""
        self.send(kind, struct.pack("<q", time))
        return self.idle()

    def idle(self) -> Any:
        return json.loads(self.receive(IDLE))

    def finish(self) -> Any:
        self.send(FINISH)
        return json.loads(self.receive(FINISHED))


class World:
    """The other side: a number, its result, and the clock."""

    def __init__(self, participant: Participant) -> None:
        self.number: Writer = participant.writer("/number", "std_msgs/msg/Float32", QoSProfile(depth=10))
        self.doubled: Reader = participant.reader("/doubled", "std_msgs/msg/Float32", QoSProfile(depth=10))
        self.clock: Writer = participant.writer("/clock", "rosgraph_msgs/msg/Clock", QoSProfile(depth=1))

    def send(self, data: bytes, time: int) -> None:
        self.number.write(data, time)

    def show(self, time: int) -> None:
        self.clock.write(b"\0\1\0\0" + struct.pack("<iI", *divmod(time, 1_000_000_000)))


@pytest.fixture
def tag() -> str:
    return fresh_tag()


@pytest.fixture
def world(tag: str) -> Iterator[World]:
    with Participant(DOMAIN, loopback_configuration(tag)) as participant:
        yield World(participant)


@pytest.fixture
def host(tag: str, world: World) -> Iterator[NodeProcess]:
    with NodeProcess(tag) as process:
        yield process


def configuration(**node: Any) -> dict[str, Any]:
    """Return the node that doubles numbers, every 50 ms."""
    times = {"execution_time_ms": 0.0, "phase_ms": 0.0}
    return {"path": [str(FIXTURES)], "messages": [], "nodes": [{**doubler(FIXTURES), **times, **node}]}


def test_a_node_says_what_it_reads_and_writes(host: NodeProcess) -> None:
    ready = host.configure(configuration())
    (writer,), (reader,) = ready["writers"], ready["readers"]
    assert (writer["topic"], reader["topic"]) == ("/doubled", "/number")
    assert {writer["type"], reader["type"]} == {"std_msgs/msg/Float32"}
    assert ready["warnings"] == []


def test_samples_come_and_go_at_their_simulated_times(host: NodeProcess, world: World) -> None:
    assert host.join(world, configuration(execution_time_ms=5.0), turn=(2, 3)) == []
    world.show(0)
    assert host.let(PUBLISH, 0)["next"] == [PERIOD, True], "its timer"
    world.send(float32(3.0), 7)
    assert host.idle() == {"answered": 1, "next": [PERIOD, True], "samples": True, "wrote": [0], "read": [1]}
    assert host.let(RUN, 0)["samples"] is False
    world.show(PERIOD)
    assert host.let(RUN, PERIOD)["next"] == [55 * MILLISECOND, False], "what it wrote can be seen then"
    assert world.doubled.take() == []
    world.show(55 * MILLISECOND)
    assert host.let(PUBLISH, 55 * MILLISECOND)["wrote"] == [1]
    stamp = 55 * MILLISECOND + 1
    received = []
    wait_until(lambda: received.extend(world.doubled.take()) or received, "a sample arrives")
    assert [(sample.source_timestamp, sample.data) for sample in received] == [(stamp, float32(6.0))]
    assert stamp % 3 == 2, "the third of three writers on the topic"
    finished = host.finish()
    ((activation,),) = [node["activations"] for node in finished["nodes"]]
    assert activation[:2] == [PERIOD, 55 * MILLISECOND]
    assert activation[3:] == [[["/number", 7]], [["/doubled", stamp]]]
    assert finished["publications"] == {"/doubled": [[stamp, 55 * MILLISECOND]]}


def test_time_stands_still_until_the_clock_shows_it(host: NodeProcess, world: World) -> None:
    host.join(world, configuration())
    host.send(PUBLISH, struct.pack("<q", PERIOD))
    world.show(0)
    world.show(PERIOD - 1)
    world.show(PERIOD)
    assert host.idle()["answered"] == 1


def test_ends_that_are_not_there_are_named(host: NodeProcess, world: World) -> None:
    missing = [["writer", "/doubled", 1, 2]]
    assert host.join(world, configuration(), others=("00" * 16,), timeout=1.0) == missing


def test_reset_starts_anew_on_the_same_wire(host: NodeProcess, world: World) -> None:
    host.join(world, configuration())
    world.send(float32(3.0), 7)
    assert host.idle()["read"] == [1]
    assert host.join(world, configuration(), RESET) == []
    world.show(0)
    assert host.let(PUBLISH, 0) == {
        "answered": 1,
        "next": [PERIOD, True],
        "samples": False,
        "wrote": [0],
        "read": [0],
    }
    assert host.finish()["publications"] == {"/doubled": []}


def test_in_real_time_nothing_happens_after_its_end_but_what_comes_is_counted(host: NodeProcess, world: World) -> None:
    host.join(world, {**configuration(), "real_time": True})
    world.send(float32(3.0), 7)
    host.send(START, struct.pack("<q", monotonic_ns()))
    received: list[Any] = []
    wait_until(lambda: received.extend(world.doubled.take()) or received, "a timer fires and a sample arrives")
    host.send(STOP)
    said = host.idle()
    assert said["answered"] == 1
    assert said["read"] == [1]
    world.send(float32(4.0), 8)
    assert host.idle()["read"] == [2], "what was on the way is told of"
    finished = host.finish()
    ((*_, last),) = [node["activations"] for node in finished["nodes"]]
    assert last[3] == [["/number", 7]]
    assert len(finished["publications"]["/doubled"]) == said["wrote"][0]
    assert finished["late"] > 0, "who is told to start now, starts a little later"


ECHO = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32
class Echo(Node):
    def __init__(self):
        super().__init__("echo")
        self.publisher = self.create_publisher(Float32, "/doubled", 10)
        self.create_subscription(Float32, "/number", self.on_number, 10)
    def on_number(self, message):
        try:
            {statement}
        except Exception:
            pass
        self.publisher.publish(message)
"""


def echo(folder: Path, statement: str) -> dict[str, Any]:
    """Return a node that answers each number on arrival."""
    (folder / "echo.py").write_text(ECHO.format(statement=statement), encoding="utf-8")
    node = {"module": "echo", "class": "Echo", "name": "Echo", "component": None}
    return {"path": [str(folder)], "messages": [], "nodes": [node]}


def test_samples_that_came_before_the_start_are_received_at_the_start(
    host: NodeProcess, world: World, tmp_path: Path
) -> None:
    host.join(world, {**echo(tmp_path, "pass"), "real_time": True})
    world.send(float32(3.0), 7)
    world.number.wait_for_acknowledgments(60_000_000_000)
    host.send(START, struct.pack("<q", monotonic_ns() + PERIOD))
    received: list[Any] = []
    wait_until(lambda: received.extend(world.doubled.take()) or received, "an answer, though no timer fires")
    host.send(STOP)
    assert host.idle()["wrote"] == [1]


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("self.create_subscription(Float32, '/late', print, 10)", "makes a subscription of /late"),
        ("self.create_publisher(Float32, '/late', 10)", "makes a publisher of /late"),
        ("self.destroy_publisher(self.publisher)", "destroys a publisher of /doubled"),
    ],
)
def test_ends_that_come_or_go_later_are_refused_at_their_line(
    host: NodeProcess, world: World, tmp_path: Path, statement: str, words: str
) -> None:
    host.join(world, echo(tmp_path, statement))
    world.show(0)
    host.let(PUBLISH, 0)
    world.send(float32(3.0), 7)
    assert host.idle()["read"] == [1]
    with pytest.raises(Failed, match=f"node.endpoint.late: the node {words} while it runs") as failure:
        host.let(PUBLISH, 0)
    assert failure.value.details["file"] == str(tmp_path / "echo.py")
    assert failure.value.details["excerpt"].strip() == statement


def test_a_node_that_has_finished_has_left_the_wire(host: NodeProcess, world: World) -> None:
    host.join(world, configuration())
    host.finish()
    wait_until(lambda: world.number.matched() == 0, "the reader is gone")
    wait_until(lambda: world.doubled.matched() == 0, "the writer is gone")


NODE = """
from rclpy.node import Node
class Bad(Node):
    def __init__(self):
        super().__init__("bad")
        {statement}
"""


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("import socket; socket.socket()", "confinement refuses socket"),
        ("import ctypes", "ctypes"),
        ("import os; os.fork()", "confinement refuses os.fork"),
        ("open('/etc/hostname', 'w')", "confinement refuses open"),
    ],
)
def test_a_node_on_the_wire_is_as_confined_as_any(
    host: NodeProcess, tmp_path: Path, statement: str, words: str
) -> None:
    (tmp_path / "bad.py").write_text(NODE.format(statement=statement), encoding="utf-8")
    node = {"module": "bad", "class": "Bad", "name": "Bad", "component": None}
    with pytest.raises(Failed, match=words) as failure:
        host.configure({"path": [str(tmp_path)], "messages": [], "nodes": [node]})
    assert failure.value.details["node"] == "Bad"
