"""Transforms: `tf2_ros` and `tf2_geometry_msgs` in simulated time."""

from __future__ import annotations

from math import cos, pi, sin
from pathlib import Path
from typing import Any

import pytest
import rclpy
import tf2_ros
from eventchain_ros2.simulation import Simulation
from node_processes import World
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time

MILLISECOND = 1_000_000
LATEST = Time()


def stamped(parent: str, child: str, x: float = 0.0, angle: float = 0.0, time: float = 0.0) -> Any:
    """Return a transform with a shift along x and a turn around z, at a time in s."""
    from geometry_msgs.msg import TransformStamped

    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, Time(seconds=time).to_msg()
    message.transform.translation.x = x
    message.transform.rotation.z, message.transform.rotation.w = sin(angle / 2), cos(angle / 2)
    return message


@pytest.fixture
def buffer(simulation: Simulation) -> tf2_ros.Buffer:
    """The odometry of a vehicle that drives and turns for 1 s, with a sensor 2 m in front of its centre."""
    buffer = tf2_ros.Buffer()
    buffer.set_transform(stamped("odom", "base", x=10.0, angle=0.0, time=1.0), "test")
    buffer.set_transform(stamped("odom", "base", x=20.0, angle=pi / 2, time=2.0), "test")
    buffer.set_transform_static(stamped("base", "lidar", x=2.0), "test")
    buffer.set_transform(stamped("other", "alone", time=1.0), "test")
    return buffer


def position(transform: Any) -> tuple[float, float]:
    shift = transform.transform.translation
    return pytest.approx((shift.x, shift.y))


def test_transforms_are_chained_at_the_latest_common_time(buffer: tf2_ros.Buffer) -> None:
    found = buffer.lookup_transform("odom", "lidar", LATEST)
    assert position(found) == (20.0, 2.0)
    assert (found.header.frame_id, found.child_frame_id, found.header.stamp.sec) == ("odom", "lidar", 2)
    back = buffer.lookup_transform("lidar", "odom", LATEST)
    assert position(back) == (-2.0, 20.0)
    assert position(buffer.lookup_transform("base", "lidar", LATEST)) == (2.0, 0.0)
    assert position(buffer.lookup_transform("base", "base", LATEST)) == (0.0, 0.0)
    assert buffer.get_latest_common_time("odom", "lidar").nanoseconds == 2_000 * MILLISECOND
    buffer.set_transform(stamped("map", "odom", x=100.0, time=1.5), "test")
    assert buffer.lookup_transform("map", "lidar", LATEST).header.stamp.nanosec == 500 * MILLISECOND


def test_between_two_samples_the_way_is_straight_and_the_turn_even(buffer: tf2_ros.Buffer) -> None:
    found = buffer.lookup_transform("odom", "base", Time(seconds=1.5))
    assert position(found) == (15.0, 0.0)
    assert found.transform.rotation.z == pytest.approx(sin(pi / 8))
    ahead = buffer.lookup_transform_full("base", Time(seconds=1), "base", Time(seconds=2), "odom")
    assert position(ahead) == (10.0, 0.0)


@pytest.mark.parametrize(
    ("target", "source", "time", "error", "text"),
    [
        ("odom", "base", 2.5, tf2_ros.ExtrapolationException, r"future.*2\.500000 but the latest data is at time 2\.0"),
        (
            "odom",
            "lidar",
            0.5,
            tf2_ros.ExtrapolationException,
            r"past.*earliest.*frame \[lidar\] to frame \[odom\]",
        ),
        ("odom", "alone", 0.0, tf2_ros.ConnectivityException, "two or more unconnected trees"),
        ("odom", "nothing", 0.0, tf2_ros.LookupException, '"nothing" .* source_frame does not exist'),
        ("nothing", "odom", 0.0, tf2_ros.LookupException, '"nothing" .* target_frame does not exist'),
        ("/odom", "base", 0.0, tf2_ros.InvalidArgumentException, "does not start with a '/'"),
    ],
)
def test_what_is_not_there_is_said(
    buffer: tf2_ros.Buffer, target: str, source: str, time: float, error: type[Exception], text: str
) -> None:
    assert issubclass(error, tf2_ros.TransformException)
    with pytest.raises(error, match=text):
        buffer.lookup_transform(target, source, Time(seconds=time))
    assert not buffer.can_transform(target, source, Time(seconds=time))
    found, reason = buffer.can_transform(target, source, Time(seconds=time), return_debug_tuple=True)
    assert (found, bool(reason)) == (False, True)


def test_a_link_beyond_the_common_frame_does_not_matter(buffer: tf2_ros.Buffer) -> None:
    buffer.set_transform(stamped("map", "odom", time=5.0), "test")
    assert buffer.can_transform("odom", "lidar", Time(seconds=1.5))
    assert not buffer.can_transform("map", "lidar", Time(seconds=1.5))


@pytest.mark.parametrize(
    "transform",
    [("a", "a"), ("", "a"), ("a", ""), ("a", "b", float("nan")), ("odom", "base", 1.0, 0.0, 1.0)],
)
def test_transforms_that_cannot_be_are_ignored_with_a_message(
    buffer: tf2_ros.Buffer, transform: tuple[Any, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    assert not buffer.set_transform(stamped(*transform), "test")
    assert "so it is ignored" in capsys.readouterr().err


def test_a_rotation_that_is_none_is_ignored(buffer: tf2_ros.Buffer, capsys: pytest.CaptureFixture[str]) -> None:
    transform = stamped("odom", "camera")
    transform.transform.rotation.w = 2.0
    assert not buffer.set_transform(transform, "test")
    assert "no unit quaternion" in capsys.readouterr().err


def test_old_transforms_are_forgotten(simulation: Simulation) -> None:
    buffer = tf2_ros.Buffer(cache_time=Duration(seconds=1))
    for time in (3.0, 1.0, 2.0, 2.5):
        buffer.set_transform(stamped("odom", "base", x=time, time=time), "test")
    assert position(buffer.lookup_transform("odom", "base", Time(seconds=2.25))) == (2.25, 0.0)
    assert not buffer.can_transform("odom", "base", Time(seconds=1.5))
    buffer.clear()
    assert not buffer.can_transform("odom", "base", LATEST)


def test_loops_are_an_error(simulation: Simulation) -> None:
    buffer = tf2_ros.Buffer()
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a")):
        buffer.set_transform(stamped(parent, child, time=1.0), "test")
    with pytest.raises(tf2_ros.LookupException, match="loop"):
        buffer.lookup_transform("a", "c", LATEST)


class Vehicle(Node):
    def __init__(self) -> None:
        super().__init__("vehicle")
        self.moving = tf2_ros.TransformBroadcaster(self)
        self.fixed = tf2_ros.StaticTransformBroadcaster(self)
        self.fixed.sendTransform(stamped("base", "lidar", x=2.0))
        self.fixed.sendTransform([stamped("base", "camera", x=3.0)])
        self.create_timer(0.1, self.move)

    def move(self) -> None:
        time = self.get_clock().now().nanoseconds / 1e9
        self.moving.sendTransform(stamped("odom", "base", x=10 * time, time=time))


class Planner(Node):
    def __init__(self) -> None:
        super().__init__("planner")
        self.buffer = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.buffer, self)
        self.found: list[float] = []
        self.errors: list[str] = []
        self.create_timer(0.25, self.look)

    def look(self) -> None:
        try:
            found = self.buffer.lookup_transform("odom", "lidar", self.get_clock().now(), Duration(seconds=1))
        except tf2_ros.TransformException as problem:
            self.errors.append(type(problem).__name__)
            found = self.buffer.lookup_transform("odom", "lidar", LATEST)
        self.found.append(found.transform.translation.x)

    async def wait(self) -> None:
        found = await self.buffer.lookup_transform_async("odom", "camera", Time(seconds=0.45))
        self.found.append(found.transform.translation.x)


def test_nodes_exchange_transforms(simulation: Simulation) -> None:
    Vehicle()
    planner = Planner()
    simulation.advance(600 * MILLISECOND)
    assert planner.found == pytest.approx([4.0, 7.0])
    assert planner.errors == ["ExtrapolationException"], "at 500 ms, the transform of this time has arrived before"


def test_a_callback_awaits_a_transform(simulation: Simulation) -> None:
    Vehicle()
    planner = Planner()
    planner.create_guard_condition(planner.wait).trigger()
    simulation.advance(240 * MILLISECOND)
    assert planner.found == []
    simulation.advance(510 * MILLISECOND)
    assert planner.found == pytest.approx([4.0, 7.5, 7.0]), "at 500 ms the transform comes before the timer"


def test_outside_of_callbacks_a_timeout_passes(simulation: Simulation) -> None:
    buffer = tf2_ros.Buffer()
    rclpy.create_node("node")
    with pytest.raises(tf2_ros.LookupException):
        buffer.lookup_transform("odom", "base", LATEST, timeout=Duration(seconds=0.5))
    assert simulation.now == 500 * MILLISECOND


def test_messages_are_transformed(buffer: tf2_ros.Buffer) -> None:
    from geometry_msgs.msg import PointStamped, PoseStamped, Twist, Vector3Stamped

    point, pose, vector = PointStamped(), PoseStamped(), Vector3Stamped()
    for message in (point, pose, vector):
        message.header.frame_id, message.header.stamp = "lidar", Time(seconds=2).to_msg()
    point.point.x = pose.pose.position.x = vector.vector.x = 1.0
    import tf2_geometry_msgs

    assert tf2_geometry_msgs.do_transform_point(point, stamped("odom", "lidar", x=5.0)).point.x == 6.0
    moved = buffer.transform(point, "odom")
    assert (moved.point.x, moved.point.y, moved.header.frame_id) == (pytest.approx(20.0), pytest.approx(3.0), "odom")
    assert buffer.transform(vector, "odom").vector.y == pytest.approx(1.0)
    turned = buffer.transform(pose, "odom").pose
    assert (turned.position.y, turned.orientation.z) == (pytest.approx(3.0), pytest.approx(sin(pi / 4)))
    with pytest.raises(tf2_ros.TypeException, match="import tf2_geometry_msgs"):
        buffer.transform(Twist(), "odom")


def test_frames_are_listed(buffer: tf2_ros.Buffer) -> None:
    assert "Frame lidar exists with parent base.\n" in buffer.all_frames_as_string()
    assert "base:\n  parent: 'odom'\n" in buffer.all_frames_as_yaml()


def test_in_real_time_a_thread_may_listen_while_a_callback_waits(world: World, tmp_path: Path) -> None:
    source = tmp_path / "looking.py"
    source.write_text(
        "import rclpy, tf2_ros\n"
        "from geometry_msgs.msg import TransformStamped\n"
        "from rclpy.duration import Duration\n"
        "rclpy.init()\n"
        "node, other = rclpy.create_node('looking'), rclpy.create_node('other')\n"
        "buffer = tf2_ros.Buffer()\n"
        "listener = tf2_ros.TransformListener(buffer, other, spin_thread=True)\n"
        "transform = TransformStamped(child_frame_id='base')\n"
        "transform.header.frame_id = 'odom'\n"
        "tf2_ros.StaticTransformBroadcaster(node).sendTransform(transform)\n"
        "def look():\n"
        "    found = buffer.lookup_transform('odom', 'base', rclpy.time.Time(), timeout=Duration(seconds=60))\n"
        "    print('found', found.child_frame_id, flush=True)\n"
        "node.create_timer(0.001, look)\n"
        "rclpy.spin(node)\n"
    )
    assert world.run(source).hears("found") == "found base"
