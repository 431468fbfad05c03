"""Warnings of a single node file."""

from __future__ import annotations

import json
import signal
from pathlib import Path

from conftest import FIXTURES
from eventchain_ros2.clock import Duration
from eventchain_ros2.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from node_processes import FLOAT, World, number, numbers
from wire import EVERY

BEST_EFFORT = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.BEST_EFFORT)


def test_policies_that_do_not_match_are_warned_of_on_both_sides(world: World) -> None:
    node = world.probe(reliable="false")
    node.hears("ready")
    world.participant.reader("/room/out", FLOAT, EVERY)
    assert node.hears("[WARN]") == (
        "[WARN] New subscription discovered on topic '/room/out', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: RELIABILITY"
    )
    reliable = world.probe()
    reliable.hears("ready")
    world.participant.writer("/room/in", FLOAT, BEST_EFFORT)
    assert reliable.hears("[WARN] New publisher") == (
        "[WARN] New publisher discovered on topic '/room/in', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: RELIABILITY"
    )


def test_missed_deadlines_are_warned_of(world: World) -> None:
    node = world.probe(deadline=0.2)
    node.hears("ready")
    deadline = QoSProfile(depth=1, deadline=Duration(seconds=0.1))
    repeated = world.repeat(world.writer("/room/in", profile=deadline), number(1.0))
    numbers(world.reader("/room/out"), 3)
    repeated.stop()
    warnings = {
        "[WARN] Deadline missed on topic '/room/in': nothing was received in time",
        "[WARN] Deadline missed on topic '/room/out': nothing was published in time",
    }
    while warnings:
        warnings.discard(node.hears("[WARN]"))


def test_a_definition_that_differs_is_warned_of(world: World, tmp_path: Path) -> None:
    file = tmp_path / "messages.json"
    other = {"fields": [["data", "float32"], ["unit", "float32"]], "constants": []}
    file.write_text(json.dumps({"std_msgs/msg/Float32": other}))
    node = world.run("--messages", file, FIXTURES / "live" / "probe.py")
    node.hears("ready")
    world.writer("/room/in")
    warning = node.hears("[WARN] The definition of std_msgs::msg::dds_::Float32_ on topic '/room/in' differs")
    assert warning.count("RIHS01_") == 2


def test_the_same_definition_is_no_warning(world: World) -> None:
    node = world.probe()
    node.hears("ready")
    world.talk()
    node.process.send_signal(signal.SIGINT)
    assert node.ends() == 0
    assert [line for line in node.said if "WARN" in line] == []


def test_other_types_on_a_topic_are_warned_of_once(world: World) -> None:
    node = world.probe()
    node.hears("ready")
    for type_name in ("std_msgs/msg/Float64", FLOAT, "std_msgs/msg/Float64"):
        world.participant.reader("/room/out", type_name, EVERY)
        world.participant.writer("/room/in", type_name, EVERY)
    warnings = {
        "[WARN] New subscription discovered on topic '/room/out', expecting std_msgs/msg/Float64 instead of "
        "std_msgs/msg/Float32. No messages will be sent to it",
        "[WARN] New publisher discovered on topic '/room/in', publishing std_msgs/msg/Float64 instead of "
        "std_msgs/msg/Float32. No messages will be received from it",
    }
    assert {node.hears("[WARN]"), node.hears("[WARN]")} == warnings
    world.participant.writer("/room/in", "std_msgs/msg/String", EVERY)
    assert node.hears("[WARN]").startswith("[WARN] New publisher discovered on topic '/room/in', publishing std_msgs")


def test_other_types_that_were_there_first_are_warned_of(world: World) -> None:
    plain = QoSProfile(depth=1, avoid_ros_namespace_conventions=True)
    world.participant.reader("room/out", "std_msgs/msg/Float64", plain)  # another topic: this is rt/room/out
    world.participant.reader("/room/out", "std_msgs/msg/Bool", EVERY)
    assert world.probe().hears("[WARN]") == (
        "[WARN] New subscription discovered on topic '/room/out', expecting std_msgs/msg/Bool instead of "
        "std_msgs/msg/Float32. No messages will be sent to it"
    )
