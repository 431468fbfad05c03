"""Executors: tests of nodes run callbacks one after the other, in simulated time."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import rclpy
from eventchain_ros2.simulation import Simulation
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import QoSProfile
from wire import DEFINITIONS

MILLISECOND = 1_000_000
FIXTURES = Path(__file__).with_name("fixtures")
SOURCES = Path(__file__).parents[1] / "python"


class Listener(Node):
    def __init__(self, name: str = "listener", depth: int = 10) -> None:
        from std_msgs.msg import Float32

        super().__init__(name)
        self.received: list[float] = []
        self.message_class = Float32
        self.create_subscription(Float32, "/number", lambda m: self.received.append(m.data), QoSProfile(depth=depth))
        self.sender = self.create_publisher(Float32, "/other", 10)
        self.fired: list[int] = []

    def every(self, seconds: float) -> None:
        self.create_timer(seconds, lambda: self.fired.append(self.get_clock().now().nanoseconds))


def send(node: Listener, *values: float) -> None:
    publisher = node.create_publisher(node.message_class, "/number", 10)
    for value in values:
        publisher.publish(node.message_class(data=value))


@pytest.mark.parametrize("executor_class", [SingleThreadedExecutor, MultiThreadedExecutor])
def test_each_spin_runs_one_callback(simulation: Simulation, executor_class: Any) -> None:
    node, executor = Listener(), executor_class()
    assert executor.add_node(node)
    assert not executor.add_node(node)
    send(node, 1.0, 2.0)
    executor.spin_once(timeout_sec=1.0)
    assert node.received == [1.0]
    executor.spin_once(timeout_sec=1.0)
    assert node.received == [1.0, 2.0]
    assert simulation.now == 0, "no time was needed"


def test_a_timeout_lets_its_time_pass(simulation: Simulation) -> None:
    node = Listener()
    rclpy.spin_once(node, timeout_sec=0.25)
    assert simulation.now == 250 * MILLISECOND
    rclpy.spin_once(node, timeout_sec=0)
    assert simulation.now == 250 * MILLISECOND


def test_a_timer_fires_at_its_time_and_at_the_end_of_a_timeout(simulation: Simulation) -> None:
    node = Listener()
    node.every(0.01)
    rclpy.spin_once(node)
    rclpy.spin_once(node, timeout_sec=0.01)
    rclpy.spin_once(node, timeout_sec=0.005)
    assert node.fired == [10 * MILLISECOND, 20 * MILLISECOND]
    assert simulation.now == 25 * MILLISECOND


def test_nothing_to_wait_for_is_said_instead_of_waited_for(simulation: Simulation) -> None:
    with pytest.raises(RuntimeError, match="nothing will ever happen"):
        rclpy.spin_once(Listener())


def test_nodes_of_nobody_wait_as_long_as_their_histories_reach(simulation: Simulation) -> None:
    spun, waiting = Listener("spun"), Listener("waiting", depth=2)
    waiting.every(0.01)
    send(spun, 1.0, 2.0, 3.0)
    for _ in range(4):
        rclpy.spin_once(spun, timeout_sec=0.02)
    assert (spun.received, waiting.received, waiting.fired) == ([1.0, 2.0, 3.0], [], [])
    for _ in range(2):
        rclpy.spin_once(waiting, timeout_sec=0)
    assert waiting.received == [2.0, 3.0]
    assert waiting.fired == [20 * MILLISECOND], "one firing for the periods that passed"
    assert simulation.now == 20 * MILLISECOND


def test_a_removed_node_is_not_run(simulation: Simulation) -> None:
    node, executor = Listener(), SingleThreadedExecutor()
    executor.add_node(node)
    executor.remove_node(node)
    send(node, 1.0)
    executor.spin_once(timeout_sec=0.01)
    assert executor.get_nodes() == []
    assert node.received == []


def test_an_exception_of_a_callback_reaches_the_caller_and_others_go_on(simulation: Simulation) -> None:
    node = Listener()

    def fail() -> None:
        raise ValueError("broken")

    node.create_timer(0.01, fail)
    other = Listener("other")
    other.every(0.01)
    with pytest.raises(ValueError, match="broken"):
        rclpy.spin_once(node, timeout_sec=0.02)
    rclpy.spin_once(other, timeout_sec=0.02)
    assert other.fired == [10 * MILLISECOND]


def test_after_the_shutdown_nothing_is_run(simulation: Simulation) -> None:
    executor = SingleThreadedExecutor()
    assert executor.shutdown()
    with pytest.raises(ExternalShutdownException):
        executor.spin_once(timeout_sec=0)
    node = Listener()
    rclpy.shutdown()
    with pytest.raises(ExternalShutdownException):
        rclpy.spin_once(node, timeout_sec=0)


def test_the_block_of_init_ends_with_a_shutdown(simulation: Simulation) -> None:
    with rclpy.init():
        assert rclpy.ok()
    assert not rclpy.ok()
    with pytest.raises(KeyError), rclpy.init():
        rclpy.shutdown()
        raise KeyError("errors of the block pass, and a second shutdown is none")


def test_pytest_runs_tests_of_a_package_with_its_messages(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text(
        "import carla_msgs.msg\n"
        "import rclpy\n"
        "def test_node():\n"
        "    rclpy.init()\n"
        "    node = rclpy.create_node('node')\n"
        "    node.create_publisher(carla_msgs.msg.CarlaEgoVehicleStatus, '/status', 10)\n"
        "    rclpy.shutdown()\n"
    )
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "eventchain_ros2.pytest_plugin"]
    environment = {"PATH": os.environ["PATH"], "PYTHONPATH": str(SOURCES), "PYTHONDONTWRITEBYTECODE": "1"}

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        words = [*command, *arguments]
        return subprocess.run(words, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)

    done = run("--messages", str(DEFINITIONS))
    assert (done.returncode, "1 passed" in done.stdout) == (0, True), done.stdout + done.stderr
    assert "No module named 'carla_msgs'" in run().stdout
