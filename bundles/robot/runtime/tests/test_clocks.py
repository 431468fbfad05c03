"""Clocks without a node: `rclpy.clock.Clock()`."""

from __future__ import annotations

import pytest
from eventchain_ros2.simulation import Simulation
from rclpy.clock import Clock, ClockType
from rclpy.node import Node

MILLISECOND = 1_000_000


class Watch(Node):
    """Reads a clock of its own beside that of the node."""

    def __init__(self) -> None:
        super().__init__("watch")
        self.own = Clock()
        self.read: list[tuple[int, int]] = []
        self.create_timer(0.01, self.look)

    def look(self) -> None:
        self.read.append((self.own.now().nanoseconds, self.get_clock().now().nanoseconds))


def test_a_clock_without_node_shows_the_time_of_the_callback(simulation: Simulation) -> None:
    watch = Watch()
    simulation.advance(25 * MILLISECOND)
    assert watch.read == [(10 * MILLISECOND, 10 * MILLISECOND), (20 * MILLISECOND, 20 * MILLISECOND)]
    assert watch.own.now().nanoseconds == 25 * MILLISECOND, "outside of callbacks"
    assert isinstance(watch.get_clock(), Clock)


def test_it_is_a_clock_of_the_system_unless_it_is_said(simulation: Simulation) -> None:
    assert Clock().now().clock_type == ClockType.SYSTEM_TIME
    assert Clock(clock_type=ClockType.STEADY_TIME).now().clock_type == ClockType.STEADY_TIME
    with pytest.raises(TypeError):
        _ = Clock().now() - Watch().get_clock().now()


def test_without_anything_that_runs_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Clock, "without_node", None)
    with pytest.raises(RuntimeError, match=r"call rclpy\.init\(\) first"):
        Clock().now()
