"""Asynchronous work: futures, coroutines as callbacks, guard conditions, rates, sleeping and waiting."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from eventchain_ros2 import context
from eventchain_ros2.simulation import Simulation
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.clock import Clock
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import ROSInterruptException
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.subscription import Subscription
from rclpy.task import Future
from rclpy.utilities import remove_ros_args
from rclpy.wait_for_message import wait_for_message

MILLISECOND = 1_000_000


class Waiting(Node):
    """Begins to wait for a future every 100 ms, which a timer completes 30 ms later."""

    def __init__(self) -> None:
        super().__init__("waiting")
        self.said: list[tuple[float, str]] = []
        self.future = Future()
        self.create_timer(0.1, self.wait)

    def say(self, what: str) -> None:
        self.said.append((self.get_clock().now().nanoseconds / MILLISECOND, what))

    async def wait(self) -> None:
        self.say("waits")
        self.timer = self.create_timer(0.03, self.complete)
        self.say(await self.future)

    def complete(self) -> None:
        self.timer.cancel()
        self.future.set_result("done")


def test_a_callback_that_awaits_goes_on_when_the_future_is_done(simulation: Simulation) -> None:
    node = Waiting()
    simulation.advance(190 * MILLISECOND)
    assert node.said == [(100.0, "waits"), (130.0, "done")]


def test_a_future_tells_those_who_wait_once(simulation: Simulation) -> None:
    future, told = Future(), []
    future.add_done_callback(lambda done: told.append(done.result()))
    assert not future.done()
    future.set_result(5)
    future.add_done_callback(lambda done: told.append(done.result() + 1))
    assert (told, future.done(), future.exception()) == ([5, 6], True, None)
    failed, cancelled = Future(), Future()
    failed.set_exception(KeyError("lost"))
    cancelled.cancel()
    with pytest.raises(KeyError):
        failed.result()
    assert (cancelled.cancelled(), cancelled.result()) == (True, None)


def test_tasks_run_as_callbacks_and_their_errors_reach_the_caller(simulation: Simulation) -> None:
    node, executor = rclpy.create_node("node"), SingleThreadedExecutor()
    with pytest.raises(RuntimeError, match="add one to the executor"):
        executor.create_task(print)
    executor.add_node(node)

    async def fail() -> None:
        raise ValueError("broken")

    task = executor.create_task(lambda a, b: a + b, 1, b=2)
    assert not task.done()
    executor.spin_until_future_complete(task, 1.0)
    assert (task.result(), simulation.now) == (3, 0)
    with pytest.raises(ValueError, match="broken"):
        executor.spin_until_future_complete(executor.create_task(fail), 1.0)


def test_spinning_for_a_future_ends_with_it_or_with_the_time(simulation: Simulation) -> None:
    node = Waiting()
    rclpy.spin_until_future_complete(node, node.future, timeout_sec=0.05)
    assert (node.future.done(), simulation.now) == (False, 50 * MILLISECOND)
    rclpy.spin_until_future_complete(node, node.future)
    assert (node.future.result(), simulation.now) == ("done", 130 * MILLISECOND)
    rclpy.spin_until_future_complete(node, node.future, timeout_sec=1.0)
    assert simulation.now == 130 * MILLISECOND


def test_a_guard_condition_runs_its_callback_once_for_triggers_before_it(simulation: Simulation) -> None:
    node = rclpy.create_node("node")
    ran: list[int] = []
    guard = node.create_guard_condition(lambda: ran.append(simulation.now))
    for _ in range(2):
        guard.trigger()
        guard.trigger()
        rclpy.spin_once(node, timeout_sec=0.01)
    guard.trigger()
    assert node.destroy_guard_condition(guard)
    rclpy.spin_once(node, timeout_sec=0.01)
    assert ran == [0, 0]


def test_a_guard_condition_waits_for_a_busy_node_and_for_its_executor(simulation: Simulation) -> None:
    process = simulation.add_process("busy", 20 * MILLISECOND)
    ran: list[int] = []
    with simulation.starting(process):
        node = rclpy.create_node("busy")
    guard = node.create_guard_condition(lambda: ran.append(simulation.now))
    node.create_timer(0.05, guard.trigger)
    rclpy.spin_once(rclpy.create_node("other"), timeout_sec=0.06)
    assert ran == []
    for _ in range(2):
        rclpy.spin_once(node)
    assert ran == [80 * MILLISECOND]


def test_outside_of_callbacks_rates_and_clocks_let_time_pass(simulation: Simulation) -> None:
    node = rclpy.create_node("node")
    rate = node.create_rate(20)
    with pytest.raises(ValueError, match="frequency must be > 0"):
        node.create_rate(0)
    for _ in range(2):
        rate.sleep()
    assert simulation.now == 100 * MILLISECOND
    assert node.get_clock().sleep_for(Duration(seconds=0.12))
    rate.sleep()
    assert simulation.now == 220 * MILLISECOND, "a period has passed"
    rate.sleep()
    assert simulation.now == 250 * MILLISECOND, "the others that have passed are skipped"
    assert Clock().sleep_until(Clock().now() + Duration(seconds=1))
    assert simulation.now == 1250 * MILLISECOND
    assert node.destroy_rate(rate)
    guard = node.create_guard_condition(rclpy.shutdown)
    guard.trigger()
    rclpy.spin_once(node)
    assert not rclpy.ok()
    with pytest.raises(ROSInterruptException):
        node.create_rate(10).sleep()


@pytest.mark.parametrize("waits", ["rate.sleep()", "clock.sleep_for(second)", "rclpy.spin_once(node)", "client"])
def test_within_a_callback_waiting_is_an_error(simulation: Simulation, waits: str) -> None:
    node = rclpy.create_node("node")
    future = Future()
    names: dict[str, Any] = {"rclpy": rclpy, "node": node, "second": Duration(seconds=1)}
    names.update(rate=node.create_rate(2), clock=node.get_clock())
    action = (lambda: rclpy.spin_until_future_complete(node, future)) if waits == "client" else None
    node.create_timer(0.1, action or (lambda: eval(waits, names)))
    with pytest.raises(RuntimeError, match="a callback or a constructor cannot wait"):
        simulation.advance(200 * MILLISECOND)


def test_a_message_is_waited_for_without_other_callbacks(simulation: Simulation) -> None:
    from std_msgs.msg import Float32

    talker, node = rclpy.create_node("talker"), rclpy.create_node("node")
    publisher = talker.create_publisher(Float32, "/number", 10)
    node.create_subscription(Float32, "/number", lambda _: pytest.fail("it is not spun"), 10)
    assert wait_for_message(Float32, node, "/number", time_to_wait=0.5) == (False, None)
    guard = talker.create_guard_condition(lambda: publisher.publish(Float32(data=2.0)))
    guard.trigger()
    rclpy.spin_once(talker, timeout_sec=0)
    assert wait_for_message(Float32, node, "number", time_to_wait=0.5) == (True, Float32(data=2.0))
    assert simulation.now == 500 * MILLISECOND


def test_contexts_share_the_life_of_the_nodes(simulation: Simulation) -> None:
    ended: list[str] = []
    with Context() as own:
        rclpy.init(["program"], context=own, domain_id=3)
        own.on_shutdown(lambda: ended.append("context"))
        node = rclpy.create_node("node", context=own)
        assert (rclpy.ok(context=own), own.get_domain_id(), ended) == (True, 3, [])
        assert node.context is rclpy.get_default_context()
    assert (rclpy.ok(), ended) == (False, ["context"])
    rclpy.try_shutdown(context=own)


def test_what_an_earlier_run_wanted_at_its_end_is_forgotten(simulation: Simulation) -> None:
    ended: list[str] = []
    rclpy.get_default_context().on_shutdown(lambda: ended.append("earlier"))
    context.enter(Simulation())
    rclpy.get_default_context().on_shutdown(lambda: ended.append("own"))
    rclpy.shutdown()
    assert ended == ["own"]


def test_arguments_of_ros_are_taken_away() -> None:
    assert remove_ros_args(["node", "a", "--ros-args", "-p", "x:=1", "--", "b"]) == ["node", "a", "b"]


def test_types_in_annotations_are_accepted() -> None:
    assert (Future[bool], Publisher["text"], Subscription["text"]) == (Future, Publisher, Subscription)


def test_what_is_published_has_arrived(simulation: Simulation) -> None:
    from std_msgs.msg import Float32

    publisher = rclpy.create_node("node").create_publisher(Float32, "number", 10)
    publisher.assert_liveliness()
    assert publisher.wait_for_all_acked(Duration(seconds=1))


class Throttled(CallbackGroup):
    pass


@pytest.mark.parametrize(
    ("kind", "arguments"),
    [
        ("timer", (1.0, print)),
        ("guard_condition", (print,)),
        ("publisher", (None, "topic", 10)),
        ("subscription", (None, "topic", print, 10)),
        ("service", (SimpleNamespace(Request=1, Response=2), "service", print)),
        ("client", (SimpleNamespace(Request=1, Response=2), "service")),
    ],
)
def test_groups_that_decide_themselves_are_refused(simulation: Simulation, kind: str, arguments: tuple[Any]) -> None:
    node = rclpy.create_node("node")
    assert isinstance(node.default_callback_group, MutuallyExclusiveCallbackGroup)
    with pytest.raises(NotImplementedError, match="callback groups of one's own are not part"):
        getattr(node, f"create_{kind}")(*arguments, callback_group=Throttled())
    with pytest.raises(NotImplementedError, match="executors that choose callbacks themselves"):
        SingleThreadedExecutor().wait_for_ready_callbacks(timeout_sec=1.0)
