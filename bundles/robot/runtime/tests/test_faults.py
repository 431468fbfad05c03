"""Effects of each kind of fault on nodes, in simulated time."""

from __future__ import annotations

import struct
from typing import Any

import pytest
from eventchain_ros2 import faults
from eventchain_ros2.faults import NEVER, Fault
from eventchain_ros2.messages import MalformedMessageError
from eventchain_ros2.processes import Process
from eventchain_ros2.simulation import Simulation
from rclpy.node import Node
from rclpy.qos import QoSProfile

MILLISECOND = 1_000_000
END = 500 * MILLISECOND


def fault(kind: str, target: str = "Sender", start: int = 200, end: int | None = 300, amount: int = 0) -> Fault:
    """Return a fault from 200 ms until 300 ms; amounts are as in a configuration."""
    made = faults.of(
        {
            "kind": kind,
            "target": target,
            "start": start * MILLISECOND,
            "end": None if end is None else end * MILLISECOND,
            "amount": amount,
            "seed": 7,
        }
    )
    assert made is not None
    return made


class Sender(Node):
    """Publishes a number every 50 ms."""

    def __init__(self) -> None:
        from std_msgs.msg import Float32

        super().__init__("sender")
        self.count = 0
        self.sent: list[tuple[float, int]] = []
        self.publisher = self.create_publisher(Float32, "/number", 10)
        self.create_timer(0.05, self.send)

    def send(self) -> None:
        from std_msgs.msg import Float32

        self.count += 1
        self.sent.append((self.get_clock().now().nanoseconds / MILLISECOND, self.count))
        self.publisher.publish(Float32(data=float(self.count)))


class Receiver(Node):
    """Records received numbers and their times, in ms."""

    def __init__(self, depth: int = 10) -> None:
        from std_msgs.msg import Float32

        super().__init__("receiver")
        self.received: list[tuple[float, float]] = []
        self.create_subscription(Float32, "/number", self.receive, QoSProfile(depth=depth))

    def receive(self, message: Any) -> None:
        self.received.append((self.get_clock().now().nanoseconds / MILLISECOND, message.data))


class Run:
    """A sender whose activations take 10 ms, and a receiver, for half a second."""

    def __init__(self, simulation: Simulation, wrong: Fault | None, depth: int = 10) -> None:
        simulation.fault = wrong
        self.process = simulation.add_process("Sender", 10 * MILLISECOND, 50 * MILLISECOND)
        with simulation.starting(self.process):
            self.sender = Sender()
        with simulation.starting(simulation.add_process("Receiver")):
            self.receiver = Receiver(depth)
        simulation.advance(END)
        self.received = self.receiver.received

    def times(self) -> list[float]:
        """Return the times of received samples, in ms."""
        return [time for time, _ in self.received]


def test_without_a_fault_every_number_arrives(simulation: Simulation) -> None:
    assert Run(simulation, None).times() == [60, 110, 160, 210, 260, 310, 360, 410, 460]


def test_what_a_killed_node_has_not_yet_published_is_never_seen(simulation: Simulation) -> None:
    wrong = fault("kill", start=205, end=None)
    run = Run(simulation, wrong)
    assert run.times() == [60, 110, 160]
    assert [activation.end for activation in run.process.activations] == [
        time * MILLISECOND for time in (60, 110, 160)
    ], "an activation that did not end is none"
    assert wrong.affected["Sender"][1] == 205 * MILLISECOND


def test_a_killed_node_receives_nothing(simulation: Simulation) -> None:
    assert Run(simulation, fault("kill", "Receiver", end=None)).times() == [60, 110, 160]


def test_a_stopped_node_ends_what_it_did_and_fires_once_when_it_goes_on(simulation: Simulation) -> None:
    run = Run(simulation, fault("stop", start=205, end=305))
    assert [time for time, _ in run.sender.sent] == [50, 100, 150, 200, 310, 350, 400, 450]
    assert run.times() == [60, 110, 160, 310, 320, 360, 410, 460]
    longest = max(activation.end - activation.start for activation in run.process.activations)
    assert longest == 110 * MILLISECOND


def test_a_stopped_node_is_free_at_once_where_it_did_nothing(simulation: Simulation) -> None:
    run = Run(simulation, fault("stop", start=220, end=330))
    assert [time for time, _ in run.sender.sent] == [50, 100, 150, 200, 330, 350, 400, 450]


@pytest.mark.parametrize(("depth", "waited"), [(10, [4, 5]), (1, [5])])
def test_what_comes_meanwhile_waits_as_far_as_the_history_reaches(
    simulation: Simulation, depth: int, waited: list[int]
) -> None:
    run = Run(simulation, fault("stop", "Receiver"), depth)
    assert [value for time, value in run.received if time == 300] == waited
    assert [value for time, value in run.received if time > 300] == [6, 7, 8, 9]


def test_delayed_activations_take_longer(simulation: Simulation) -> None:
    wrong = fault("delay", amount=25 * MILLISECOND)
    run = Run(simulation, wrong)
    assert run.times() == [60, 110, 160, 235, 285, 310, 360, 410, 460]
    assert wrong.affected["Sender"] == (2, 200 * MILLISECOND)


def test_a_flood_is_of_publications(simulation: Simulation) -> None:
    run = Run(simulation, fault("flood", amount=3))
    assert run.times() == [60, 110, 160, *[210] * 4, *[260] * 4, 310, 360, 410, 460]
    assert [len(activation.writes) for activation in run.process.activations] == [1, 1, 1, 4, 4, 1, 1, 1, 1]
    assert len(simulation.topics["/number"].publications) == 15


def test_repeated_messages_come_again(simulation: Simulation) -> None:
    run = Run(simulation, fault("repeat", "/number", amount=1))
    assert [value for time, value in run.received if 200 <= time < 300] == [4, 4, 5, 5]


def test_what_the_world_publishes_is_its_own_affair(simulation: Simulation) -> None:
    assert fault("repeat", "/number", amount=1).sent("", "/number", 250 * MILLISECOND, b"1") == [b"1"]


def test_dropped_messages_are_none_and_still_take_their_time(simulation: Simulation) -> None:
    run = Run(simulation, fault("drop", "/number", amount=1_000_000))
    assert run.times() == [60, 110, 160, 310, 360, 410, 460]
    assert len(run.process.activations) == 9
    assert len(simulation.topics["/number"].publications) == 7


def test_a_share_is_dropped_the_same_way_each_time() -> None:
    def kept() -> list[bool]:
        wrong = fault("drop", "/number", 0, None, 300_000)
        return [wrong.sent("Sender", "/number", time, b"x") != [] for time in range(1000)]

    assert kept() == kept()
    assert 650 < sum(kept()) < 750


def test_corrupt_messages_keep_header_and_length() -> None:
    data = b"\0\1\0\0" + struct.pack("<f", 1.0)
    first, again = (fault("corrupt", "/number").sent("Sender", "/number", 250 * MILLISECOND, data) for _ in "12")
    assert first == again
    assert first[0][:4] == data[:4]
    assert len(first[0]) == len(data)
    assert first[0] != data


def test_what_cannot_be_decoded_any_more_is_lost(simulation: Simulation) -> None:
    from std_msgs.msg import Float32, String

    node = Node("writer")
    numbers, texts = node.create_publisher(Float32, "/n", 1), node.create_publisher(String, "/t", 1)
    number, text = b"\0\1\0\0" + struct.pack("<f", 1.5), b"\0\1\0\0\2\0\0\0a\0"
    assert numbers.decodes(number)
    assert not numbers.decodes(number[:-1])
    assert texts.decodes(text)
    assert not texts.decodes(text.replace(b"\2", b"\xff"))
    assert not texts.decodes(text.replace(b"a", b"\xff"))
    simulation.fault = fault("corrupt", "/t", 0, None)
    process = simulation.add_process("Writer")
    with simulation.starting(process):
        writer = Node("other")
        for _ in range(50):
            writer.create_publisher(String, "/t", 1).publish(String(data="text"))
    kept = len(simulation.topics["/t"].publications)
    assert 0 < kept < 50, "some of the changed bytes are those of the length"


def test_a_node_that_fails_is_gone_and_the_others_go_on(simulation: Simulation) -> None:
    lost: list[tuple[int, str]] = []

    def survives(process: Process, error: BaseException) -> bool:
        lost.append((simulation.now, process.name))
        return isinstance(error, MalformedMessageError | RuntimeError)

    simulation.survives = survives
    simulation.fault = fault("kill", "Nobody")
    process = simulation.add_process("Receiver")
    with simulation.starting(process):
        receiver = Receiver()
    with simulation.starting(simulation.add_process("Sender", 0, 50 * MILLISECOND)):
        sender = Sender()

    def fail(_: Any) -> None:
        raise RuntimeError("broken")

    subscription: Any = next(iter(receiver.subscriptions))
    subscription.callback = fail
    simulation.advance(END)
    assert lost == [(50 * MILLISECOND, "Receiver")]
    assert sender.count == 9
    assert process.busy_until == NEVER


@pytest.mark.parametrize(("amount", "shown"), [(60_000, [60_200, 60_250]), (-150, [50, 100])])
def test_clocks_jump_and_timers_keep_their_periods(simulation: Simulation, amount: int, shown: list[int]) -> None:
    run = Run(simulation, fault("clock_jump", "", amount=amount * MILLISECOND))
    assert [time for time, _ in run.sender.sent] == [50, 100, 150, *shown, 300, 350, 400, 450]
    assert [activation.start for activation in run.process.activations] == [
        time * MILLISECOND for time in range(50, 500, 50)
    ]


def test_no_fault_of_a_node_is_one_of_the_world() -> None:
    assert faults.of({"kind": "dead_sensor"}) is None
    assert faults.of(None) is None
