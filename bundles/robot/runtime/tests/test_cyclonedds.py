"""Nodes on plain Cyclone DDS in simulated time."""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from eventchain_ros2.dds import INFINITY, DataReader, DataWriter, DomainParticipant, Policy, Qos, Topic
from eventchain_ros2.idl import prepare
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.node import Node
from eventchain_ros2.simulation import Simulation
from protocol import MILLISECOND, Failed, HostProcess, doubler, float32

FIXTURES = Path(__file__).with_name("fixtures")
RELIABLE = Policy.Reliability.Reliable(max_blocking_time=INFINITY)


@pytest.fixture
def types() -> Iterator[ModuleType]:
    """Provide the message classes of the fixture."""
    sys.path.insert(0, str(FIXTURES))
    from dds import messages

    yield messages
    sys.path.remove(str(FIXTURES))


def configuration(**component: Any) -> dict[str, Any]:
    """Return the node that doubles numbers, every 50 ms."""
    node = doubler(FIXTURES, "dds", **component)
    return {
        "path": [str(FIXTURES)],
        "messages": [],
        "nodes": [{**node, "execution_time_ms": 5.0, "phase_ms": 12.5}],
        "world_publishes": [{"topic": "/number", "type": "std_msgs/msg/Float32"}],
        "world_subscribes": [{"topic": "/doubled", "type": "std_msgs/msg/Float32"}],
    }


def test_the_host_executes_a_node_with_its_period() -> None:
    with HostProcess() as host:
        ready = host.configure(configuration())
        assert ready["warnings"] == []
        assert host.step(50 * MILLISECOND, (0, float32(3.0))) == [(17_500_000, 0, float32(6.0))]
        assert host.step(100 * MILLISECOND, (0, float32(4.0))) == [(67_500_000, 0, float32(8.0))]
        (node,) = host.finish()["nodes"]
        times = [(start, end, reads, writes) for start, end, _, reads, writes in node["activations"]]
        assert times == [
            (12_500_000, 17_500_000, [["/number", 0]], [["/doubled", 0]]),
            (62_500_000, 67_500_000, [["/number", 1]], [["/doubled", 1]]),
        ]


def test_a_component_is_checked() -> None:
    with HostProcess() as host:
        host.configure(configuration(outputs=[{"name": "tripled"}]))
        with pytest.raises(Failed, match=r"component\.result\.keys"):
            host.step(50 * MILLISECOND, (0, float32(3.0)))


def test_nodes_of_both_kinds_share_topics(simulation: Simulation, types: ModuleType) -> None:
    participant, node, heard = DomainParticipant(), Node("listener"), []
    from std_msgs.msg import String  # type: ignore[import-not-found]

    node.create_subscription(String, "/text", lambda message: heard.append(message.data), 10)
    publisher = node.create_publisher(String, "/answer", 10)
    writer = DataWriter(participant, Topic(participant, "rt/text", types.std_msgs__String))
    reader = DataReader(participant, Topic(participant, "rt/answer", types.std_msgs__String))
    writer.write(types.std_msgs__String(data="hello"))
    publisher.publish(String(data="hello, too"))
    simulation.advance(1)
    assert heard == ["hello"]
    assert [message.data for message in reader.take(N=9)] == ["hello, too"]


def test_a_message_is_read_as_it_was_written(simulation: Simulation, types: ModuleType) -> None:
    participant = DomainParticipant()
    topic = Topic(participant, "rt/imu", types.sensor_msgs__Imu)
    writer, reader = DataWriter(participant, topic), DataReader(participant, topic)
    message = types.sensor_msgs__Imu(name="abcde", plain=0.1, octets=[1, 2], flags=[True, False])
    message.header.frame_id = "map"
    message.header.stamp.sec = -7
    message.covariance = array("d", range(9))
    message.ranges = array("f", [0.5, 1.5])
    message.stamps = [types.builtin_interfaces__Time(sec=1), types.builtin_interfaces__Time(nanosec=2)]
    writer.write(message)
    simulation.advance(1)
    (read,) = reader.take(N=2)
    assert read.header == message.header
    assert (read.name, read.plain, read.flags, read.stamps) == ("abcde", 0.1, [True, False], message.stamps)
    assert list(read.octets) == [1, 2]
    assert list(read.covariance) == list(range(9))
    assert list(read.ranges) == [0.5, 1.5]


def test_bytes_are_those_of_the_same_message_of_ros(messages: Messages, types: ModuleType) -> None:
    header: Any = messages.get("std_msgs/msg/Header")
    ros = header(frame_id="map")
    ros.stamp.sec = 5
    plain = types.std_msgs__Header(frame_id="map")
    plain.stamp.sec = 5
    prepare(types.std_msgs__Header)
    assert to_cdr(plain) == to_cdr(ros)
    assert from_cdr(types.std_msgs__Header, to_cdr(ros)) == plain


def test_only_the_last_samples_are_kept(simulation: Simulation, types: ModuleType) -> None:
    participant = DomainParticipant()
    topic = Topic(participant, "rt/number", types.std_msgs__Float32)
    writer = DataWriter(participant, topic)
    last = DataReader(participant, topic, qos=Qos(Policy.History.KeepLast(2)))
    every = DataReader(participant, topic, qos=Qos(Policy.History.KeepAll))
    for number in range(5):
        writer.write(types.std_msgs__Float32(data=float(number)))
    simulation.advance(1)
    assert [message.data for message in last.read(N=9)] == [3.0, 4.0]
    assert [message.data for message in every.take(N=3)] == [0.0, 1.0, 2.0]
    assert [message.data for message in every.take(N=3)] == [3.0, 4.0]
    assert every.take() == []


def test_policies_that_do_not_match_are_warned_of(simulation: Simulation, types: ModuleType) -> None:
    participant = DomainParticipant()
    topic = Topic(participant, "rt/number", types.std_msgs__Float32)
    DataWriter(participant, topic, qos=Qos(Policy.Reliability.BestEffort, Policy.Deadline(20)))
    DataReader(participant, topic, qos=Qos(RELIABLE, Policy.Durability.TransientLocal, Policy.Deadline(10)))
    manual = Policy.Liveliness.ManualByTopic(lease_duration=INFINITY)
    DataReader(participant, topic, qos=Qos(manual))
    DataReader(participant, topic, qos=Qos(Policy.Liveliness.Automatic(lease_duration=INFINITY)))
    policies = [warning.message.rpartition(": ")[2] for warning in simulation.warnings]
    assert policies == ["RELIABILITY, DURABILITY, DEADLINE", "LIVELINESS"]


def test_types_that_do_not_match_are_warned_of(simulation: Simulation, types: ModuleType) -> None:
    participant = DomainParticipant()
    DataWriter(participant, Topic(participant, "rt/number", types.std_msgs__Float32))
    DataReader(participant, Topic(participant, "rt/number", types.std_msgs__String))
    (warning,) = simulation.warnings
    assert warning.id == "topic.type.mismatch"
    assert "std_msgs/msg/String is subscribed and std_msgs/msg/Float32 published" in warning.message


def test_what_cannot_be_written_is_refused(simulation: Simulation, types: ModuleType) -> None:
    participant = DomainParticipant()
    writer = DataWriter(participant, Topic(participant, "rt/number", types.std_msgs__Float32))
    with pytest.raises(TypeError, match="is not of type"):
        writer.write(types.std_msgs__String())
    with pytest.raises(AssertionError, match="data"):
        writer.write(types.std_msgs__Float32(data="1"))
    with pytest.raises(TypeError, match="IdlStruct"):
        Topic(participant, "rt/number", int)
    with pytest.raises(TypeError, match="policy"):
        DataReader(participant, writer.topic, qos=Qos("fast"))


def test_samples_of_the_wire_are_plain_cdr(types: ModuleType) -> None:
    prepare(types.std_msgs__Float32)
    assert to_cdr(types.std_msgs__Float32(data=1.5)) == b"\x00\x01\x00\x00" + struct.pack("<f", 1.5)
