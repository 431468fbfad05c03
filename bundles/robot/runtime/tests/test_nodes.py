"""The runtime for node code: timers, topics, parameters, clocks, logs."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from eventchain_ros2.simulation import Simulation
from rclpy.duration import Duration
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidTopicNameException,
    NotInitializedException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)
from rclpy.executors import SingleThreadedExecutor
from rclpy.logging import LoggingSeverity
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_best_available
from rclpy.time import Time
from recorder import MILLISECOND, Recorder, number


def busy_recorder(simulation: Simulation, execution: float, phase: float = 0.0) -> Recorder:
    process = simulation.add_process("busy", round(execution * MILLISECOND), round(phase * MILLISECOND))
    with simulation.starting(process):
        node = Recorder()
        node.create_timer(0.010, node.fire)
    return node


def test_a_timer_fires_first_after_one_period(simulation: Simulation) -> None:
    node = Recorder()
    node.create_timer(1.0 / 20.0, node.fire)
    simulation.advance(151 * MILLISECOND)
    assert node.fired == [50.0, 100.0, 150.0]


def test_a_phase_sets_the_first_firing(simulation: Simulation) -> None:
    node = busy_recorder(simulation, execution=0, phase=2.5)
    simulation.advance(30 * MILLISECOND)
    assert node.fired == [2.5, 12.5, 22.5]


def test_a_busy_node_skips_missed_periods_without_a_burst(simulation: Simulation) -> None:
    node = busy_recorder(simulation, execution=25)
    simulation.advance(130 * MILLISECOND)
    # Due at 10; free at 35, when those of 20 and 30 have passed: one late call, and the next one is due at 40.
    assert node.fired == [10.0, 35.0, 60.0, 85.0, 110.0]


def test_a_timer_that_takes_exactly_its_period_keeps_its_rhythm(simulation: Simulation) -> None:
    node = busy_recorder(simulation, execution=10)
    simulation.advance(45 * MILLISECOND)
    assert node.fired == [10.0, 20.0, 30.0, 40.0]


def test_a_cancelled_timer_rests_until_reset(simulation: Simulation) -> None:
    node = Recorder()
    timer = node.create_timer(0.010, node.fire)
    simulation.advance(15 * MILLISECOND)
    timer.cancel()
    assert timer.is_canceled()
    simulation.advance(47 * MILLISECOND)
    timer.reset()
    simulation.advance(60 * MILLISECOND)
    assert node.fired == [10.0, 57.0]


def test_a_timer_may_cancel_itself(simulation: Simulation) -> None:
    node = Recorder()

    def once() -> None:
        node.fire()
        timer.cancel()

    timer = node.create_timer(0.010, once)
    simulation.advance(50 * MILLISECOND)
    assert node.fired == [10.0]


def test_a_destroyed_node_does_nothing_any_more(simulation: Simulation) -> None:
    node = Recorder()
    node.create_timer(0.010, node.fire)
    node.subscribe("/number")
    publisher = Recorder("other").advertise("/number")
    node.destroy_node()
    publisher.publish(number(1.0))
    simulation.advance(50 * MILLISECOND)
    assert (node.fired, node.received) == ([], [])


def test_a_chain_of_idle_nodes_reacts_within_one_instant(simulation: Simulation) -> None:
    first, second = Recorder("first"), Recorder("second")
    publisher = first.advertise("/number")
    first.create_timer(0.010, lambda: publisher.publish(number(1.0)))
    second.subscribe("/number")
    second.create_timer(0.010, lambda: second.fired.append(len(second.received)))
    simulation.advance(11 * MILLISECOND)
    assert second.fired == [1], "the sample of 10 ms comes before the second timer of 10 ms"


def test_samples_wait_for_a_busy_node_and_the_oldest_ones_are_lost(simulation: Simulation) -> None:
    node = busy_recorder(simulation, execution=5)
    node.subscribe("/number", 2)
    sender = Recorder("sender")
    publisher = sender.advertise("/number")
    values = iter((1.0, 2.0, 3.0, 4.0))
    sender.create_timer(0.011, lambda: [publisher.publish(number(next(values))) for _ in range(4)])
    simulation.advance(16 * MILLISECOND)
    assert node.received == [(15.0, 3.0), (15.0, 4.0)]


def test_a_callback_that_publishes_is_an_activation(simulation: Simulation) -> None:
    process = simulation.add_process("relay", 3 * MILLISECOND)
    with simulation.starting(process):
        relay = Recorder("relay")
    publisher = relay.advertise("/copy")
    relay.create_subscription(type(number(0.0)), "/number", publisher.publish, 10)
    receiver = Recorder("receiver")
    receiver.subscribe("/copy")
    receiver.advertise("/number").publish(number(1.0))
    simulation.advance(10 * MILLISECOND)
    assert receiver.received == [(3.0, 1.0)]
    (activation,) = process.activations
    assert (activation.start, activation.end) == (0, 3 * MILLISECOND)
    assert (activation.reads, activation.writes) == ([("/number", 0)], [("/copy", 0)])


def test_a_receiver_cannot_change_what_others_receive(simulation: Simulation) -> None:
    greedy, modest = Recorder("greedy"), Recorder("modest")

    def spoil(message: Any) -> None:
        message.data = -1.0

    greedy.create_subscription(type(number(0.0)), "/number", spoil, 10)
    modest.subscribe("/number")
    sent = number(1.0)
    greedy.advertise("/number").publish(sent)
    sent.data = 7.0
    simulation.advance(MILLISECOND)
    assert modest.received == [(0.0, 1.0)]


def test_different_types_on_a_topic_deliver_nothing_and_warn(simulation: Simulation) -> None:
    from std_msgs.msg import String

    node = Recorder()
    node.subscribe("/number")
    node.create_publisher(String, "/number", 10).publish(String(data="one"))
    simulation.advance(MILLISECOND)
    assert node.received == []
    assert [warning.id for warning in simulation.warnings] == ["topic.type.mismatch"]


def test_names_are_completed_and_checked(simulation: Simulation) -> None:
    node = Node("camera", namespace="front")
    message_class = type(number(0.0))
    names = [node.create_publisher(message_class, topic, 10).topic_name for topic in ("/a", "b", "~/c")]
    assert names == ["/a", "/front/b", "/front/camera/c"]
    assert node.get_fully_qualified_name() == "/front/camera"
    for topic in ("", "/a b", "/a/", "1", "a__b"):
        with pytest.raises(InvalidTopicNameException):
            node.create_publisher(message_class, topic, 10)


def test_only_messages_of_the_publishers_type_can_be_published(simulation: Simulation) -> None:
    from std_msgs.msg import Float64

    with pytest.raises(TypeError, match="Expected"):
        Recorder().advertise("/number").publish(Float64())
    with pytest.raises(TypeError, match="not a message class of Eventchain's runtime"):
        Recorder("other").create_subscription(str, "/number", print, 10)


def test_raw_subscriptions_get_bytes(simulation: Simulation) -> None:
    node = Recorder()
    received: list[bytes] = []
    node.create_subscription(type(number(0.0)), "/number", received.append, 10, raw=True)
    node.advertise("/number").publish(number(0.0))
    simulation.advance(1)
    assert received == [b"\0\1\0\0" + bytes(4)]


def test_parameters_are_declared_before_use(simulation: Simulation) -> None:
    node = Node("node", parameter_overrides=[Parameter("gain", value=2.0)])
    assert node.declare_parameter("gain", 1.0).value == 2.0
    assert node.declare_parameter("limit", 3).value == 3
    assert node.get_parameter("limit").get_parameter_value().integer_value == 3
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter("other")
    with pytest.raises(ParameterAlreadyDeclaredException):
        node.declare_parameter("gain", 1.0)
    (result,) = node.set_parameters([Parameter("limit", value=4)])
    assert result.successful
    assert node.get_parameter("limit").value == 4
    with pytest.raises(InvalidParameterTypeException, match="expecting type 'INTEGER'"):
        node.set_parameters([Parameter("limit", value="four")])


def test_parameters_can_be_declared_together_and_by_type(simulation: Simulation) -> None:
    node = Node("node")
    node.declare_parameters("wheel", [("radius", 0.3), ("names", Parameter.Type.STRING_ARRAY), ("free",)])
    node.set_parameters([Parameter("wheel.names", value=["left", "right"])])
    values = [parameter.value for parameter in node.get_parameters(["wheel.radius", "wheel.names", "wheel.free"])]
    assert values == [0.3, ["left", "right"], None]
    assert node.has_parameter("use_sim_time")
    assert not node.has_parameter("radius")


def test_times_can_be_calculated_with(messages: Any) -> None:
    time = Time(seconds=1, nanoseconds=5)
    assert time.seconds_nanoseconds() == (1, 5)
    assert (time + Duration(seconds=1.5)).nanoseconds == 2_500_000_005
    assert time - Time(seconds=1) == Duration(nanoseconds=5)
    assert Time.from_msg(time.to_msg()).nanoseconds == time.nanoseconds
    assert Duration(seconds=1) > Duration(seconds=0.5)
    assert Time(seconds=2) >= time
    with pytest.raises(TypeError, match="different clock types"):
        Time.from_msg(time.to_msg()) < time  # noqa: B015


def test_logs_have_the_simulated_time_and_keep_their_conditions(
    simulation: Simulation, capsys: pytest.CaptureFixture[str]
) -> None:
    node = Recorder()

    def log() -> None:
        node.get_logger().info("once", once=True)
        node.get_logger().warn("slow", throttle_duration_sec=0.025)
        node.get_logger().debug("hidden")

    node.create_timer(0.010, log)
    simulation.advance(45 * MILLISECOND)
    assert capsys.readouterr().err.splitlines() == [
        "[INFO] [0.010000000] [recorder]: once",
        "[WARN] [0.010000000] [recorder]: slow",
        "[WARN] [0.040000000] [recorder]: slow",
    ]


def test_a_logger_takes_its_level_as_an_argument(simulation: Simulation, capsys: pytest.CaptureFixture[str]) -> None:
    logger = Recorder().get_logger()
    assert logger.log("broken", LoggingSeverity.ERROR)
    assert not logger.log("hidden", LoggingSeverity.DEBUG)
    assert [line.split(" ", 1)[0] for line in capsys.readouterr().err.splitlines()] == ["[ERROR]"]


def test_what_is_missing_is_refused_by_name(simulation: Simulation) -> None:
    node = Recorder()
    with pytest.raises(TypeError, match="is not a type of services"):
        node.create_service(object, "service", print)
    with pytest.raises(NotImplementedError, match="event callbacks are not part"):
        node.create_publisher(type(number(0.0)), "/number", 10, event_callbacks=object())
    with pytest.raises(NotImplementedError, match="in simulated time a host runs the nodes"):
        rclpy.spin(node)
    with pytest.raises(NotImplementedError, match="in simulated time a host runs the nodes"):
        SingleThreadedExecutor().spin()
    with pytest.raises(NotImplementedError, match="waitables are not part"):
        node.add_waitable(object())
    with pytest.raises(AttributeError, match="no attribute 'create_nothing'"):
        node.create_nothing()


def test_nodes_live_between_init_and_shutdown(simulation: Simulation) -> None:
    rclpy.init()
    with pytest.raises(RuntimeError, match="only be called once"):
        rclpy.init()
    node = Recorder()
    node.create_timer(0.010, node.fire)
    assert rclpy.ok()
    rclpy.shutdown()
    assert not rclpy.ok()
    simulation.advance(50 * MILLISECOND)
    assert node.fired == []
    with pytest.raises(NotInitializedException):
        Recorder()
    with pytest.raises(RuntimeError, match="already shut down"):
        rclpy.shutdown()
    rclpy.try_shutdown()


@pytest.mark.parametrize("qos", [10, qos_profile_best_available])
def test_what_is_made_in_a_callback_is_decided_at_once(simulation: Simulation, qos: Any) -> None:
    class Late(Node):
        def __init__(self) -> None:
            super().__init__("late")
            self.made: Any = None
            self.count = 0
            self.create_timer(0.01, self.fire)

        def fire(self) -> None:
            self.made = self.made or self.create_publisher(type(number(0.0)), "/late", qos)
            self.count += 1
            self.made.publish(number(float(self.count)))

    node = Recorder()
    node.subscribe("/late", 10)
    Late()
    simulation.advance(55 * MILLISECOND)
    simulation.advance(105 * MILLISECOND)
    assert [value for _, value in node.received] == [float(each) for each in range(1, 11)]
