"""Messages that belong together: `message_filters` in simulated time."""

from __future__ import annotations

from typing import Any

import message_filters
import pytest
from eventchain_ros2.simulation import Simulation
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time

MILLISECOND = 1_000_000


def at(milliseconds: int, name: str = "") -> Any:
    from sensor_msgs.msg import Range

    message = Range()
    message.header.stamp, message.header.frame_id = Time(nanoseconds=milliseconds * MILLISECOND).to_msg(), name
    return message


def stamps(*messages: Any) -> list[int]:
    return [Time.from_msg(message.header.stamp).nanoseconds // MILLISECOND for message in messages]


def fed(kind: Any, *arguments: Any, messages: list[tuple[int, int]], sources: int = 2) -> list[list[int]]:
    """Return the stamps of the messages that come together, of `(source, stamp in ms)`."""
    inputs = [SimpleFilter() for _ in range(sources)]
    together: list[list[int]] = []
    synchronizer = kind(inputs, *arguments)
    synchronizer.registerCallback(lambda *found: together.append(stamps(*found)))
    for source, stamp in messages:
        inputs[source].signalMessage(at(stamp))
    return together


def test_equal_stamps_come_together_in_any_order(simulation: Simulation) -> None:
    messages = [(0, 10), (0, 20), (1, 20), (1, 10), (1, 30), (0, 31)]
    assert fed(TimeSynchronizer, 10, messages=messages) == [[20, 20], [10, 10]]


def test_a_queue_keeps_the_newest(simulation: Simulation) -> None:
    messages = [(0, 10), (0, 20), (0, 30), (1, 10), (1, 20), (1, 30)]
    assert fed(TimeSynchronizer, 2, messages=messages) == [[20, 20], [30, 30]]
    assert fed(TimeSynchronizer, 2, messages=[(0, 10), (1, 20), (1, 30), (1, 10)]) == [], "10 is too old at once"


@pytest.mark.parametrize(
    ("slop", "messages", "expected"),
    [
        (0.005, [(0, 10), (1, 14), (0, 20), (1, 25)], [[10, 14]]),
        (0.006, [(0, 10), (1, 14), (0, 20), (1, 25)], [[10, 14], [20, 25]]),
        (0.010, [(0, 10), (0, 12), (1, 13)], [[12, 13]]),
        (0.010, [(0, 10), (1, 13), (1, 14), (0, 15)], [[10, 13], [15, 14]]),
    ],
)
def test_similar_stamps_come_together_once(
    simulation: Simulation, slop: float, messages: list[tuple[int, int]], expected: list[list[int]]
) -> None:
    assert fed(ApproximateTimeSynchronizer, 10, slop, messages=messages) == expected


def test_three_sources_are_no_farther_apart_than_the_slop(simulation: Simulation) -> None:
    messages = [(0, 10), (1, 14), (2, 18), (2, 13)]
    assert fed(ApproximateTimeSynchronizer, 10, 0.007, messages=messages, sources=3) == [[10, 14, 13]]


def test_without_a_header_the_arrival_counts_on_request(simulation: Simulation) -> None:
    from std_msgs.msg import Float32

    inputs, together = [SimpleFilter(), SimpleFilter()], []
    ApproximateTimeSynchronizer(inputs, 10, 0.1, allow_headerless=True).registerCallback(
        lambda *found: together.append([message.data for message in found])
    )
    for data, source in enumerate(inputs):
        source.signalMessage(Float32(data=float(data)))
    assert together == [[0.0, 1.0]]
    TimeSynchronizer(inputs, 10)
    with pytest.raises(TypeError, match="Float32 has no header with a stamp: pass allow_headerless=True"):
        inputs[0].signalMessage(Float32())


def test_a_cache_finds_messages_by_time(simulation: Simulation) -> None:
    source, passed = SimpleFilter(), []
    cache = Cache(source, 3)
    cache.registerCallback(lambda message, name: passed.append((name, *stamps(message))), "cache")
    assert (cache.getLast(), cache.getLatestTime(), cache.getElemAfterTime(Time())) == (None, None, None)
    for stamp in (10, 30, 20, 40):
        source.signalMessage(at(stamp))
    assert passed == [("cache", 10), ("cache", 30), ("cache", 20), ("cache", 40)]

    def time(milliseconds: int) -> Time:
        return Time(nanoseconds=milliseconds * MILLISECOND)

    assert stamps(*cache.getInterval(time(15), time(30))) == [20, 30]
    assert stamps(cache.getElemAfterTime(time(21)), cache.getElemBeforeTime(time(21))) == [30, 20]
    assert stamps(cache.getLast()) == [40]
    assert (cache.getOldestTime().nanoseconds, cache.getLastestTime().nanoseconds) == (20_000_000, 40_000_000)


def test_a_sample_counts_as_read_when_it_is_given_on(simulation: Simulation) -> None:
    kind = type(at(0))
    fusion, sensors = Node("fusion"), Node("sensors")
    output = fusion.create_publisher(kind, "fused", 10)
    sources = [Subscriber(fusion, kind, name) for name in ("left", "right")]
    both = TimeSynchronizer(sources, 5)
    both.registerCallback(lambda *_: output.publish(at(0)))
    left, right = (sensors.create_publisher(kind, name, 10) for name in ("left", "right"))
    for now, (publisher, stamp) in enumerate([(left, 10), (left, 20), (left, 30), (right, 20)], 1):
        publisher.publish(at(stamp))
        simulation.advance(now * MILLISECOND)
    (activation,) = sources[0].sub.process.activations
    assert dict(activation.reads) == {"/left": 1, "/right": 0}


def test_subscriptions_are_sources(simulation: Simulation) -> None:
    heard: list[list[int]] = []

    class Fusion(Node):
        def __init__(self) -> None:
            super().__init__("fusion")
            kind = type(at(0))
            left = Subscriber(self, kind, "left")
            right = Subscriber(self, kind, "/right", qos_profile=qos_profile_sensor_data)
            self.both = message_filters.ApproximateTimeSynchronizer([left, right], 5, 0.02)
            self.both.registerCallback(lambda one, other: heard.append(stamps(one, other)))

    Fusion()
    sensors = Node("sensors")
    left, right = (sensors.create_publisher(type(at(0)), name, 10) for name in ("left", "right"))
    left.publish(at(100))
    right.publish(at(110))
    right.publish(at(150))
    simulation.advance(MILLISECOND)
    assert heard == [[100, 110]]
    with pytest.raises(AttributeError, match=r"does not provide message_filters\.Chain"):
        message_filters.Chain  # noqa: B018
