"""Effects of each standard fault of an output."""

from __future__ import annotations

from typing import Any

import pytest
from eventchain_ros2 import faults, output_faults
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.output_faults import OutputFault
from eventchain_ros2.simulation import Simulation
from test_faults import Run

FLOAT = "std_msgs/msg/Float32"
FLOATS = [-3.4e38, 3.4e38]


def fault(
    messages: Messages, change: str, amount: float = 0, field: str = "data", kind: str = FLOAT, topic: str = "/number"
) -> OutputFault:
    """Return a fault of the messages of the node `Sender`."""
    made = output_faults.of(
        {
            "kind": "output",
            "target": "Sender",
            "topic": topic,
            "type": kind,
            "field": field,
            "change": change,
            "amount": amount,
            "range": [0, 255] if kind.endswith("UInt8") else FLOATS,
            "seed": 7,
        },
        messages.get,
    )
    assert made is not None
    return made


def numbers(simulation: Simulation, wrong: OutputFault) -> list[float]:
    """Return the numbers that are received of 1 to 9."""
    return [number for _, number in Run(simulation, wrong).received]


@pytest.mark.parametrize(
    ("change", "amount", "received"),
    [
        ("stuck", 2.5, [2.5] * 9),
        ("first", 0, [1] * 9),
        ("inverted", 0, [-1, -2, -3, -4, -5, -6, -7, -8, -9]),
        ("scaled", 0.5, [0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5]),
        ("shifted", -1, [0, 1, 2, 3, 4, 5, 6, 7, 8]),
    ],
)
def test_a_number_is_wrong(
    simulation: Simulation, messages: Messages, change: str, amount: float, received: list[float]
) -> None:
    assert numbers(simulation, fault(messages, change, amount)) == received


@pytest.mark.parametrize(
    ("change", "amount", "received"),
    [
        ("dropped", 0, []),
        ("first", 0, [1] * 9),
        ("held", 4, [1, 1, 1, 1, 5, 5, 5, 5, 9]),
    ],
)
def test_messages_are_missing_or_old(
    simulation: Simulation, messages: Messages, change: str, amount: float, received: list[float]
) -> None:
    assert numbers(simulation, fault(messages, change, amount, field="")) == received


def test_messages_are_late(simulation: Simulation, messages: Messages) -> None:
    wrong = fault(messages, "delayed", 100, field="")
    run = Run(simulation, wrong)
    assert run.times() == [160, 210, 260, 310, 360, 410, 460]
    assert run.received[0][1] == 1
    assert wrong.affected["Sender"][0] == 9


def test_noise_is_bounded_and_the_same_for_a_seed(messages: Messages) -> None:
    def noisy() -> list[float]:
        wrong = fault(messages, "noisy", 0.5)
        return [_sent(wrong, messages, FLOAT, data=1.0).data for _ in range(50)]

    one = noisy()
    assert one == noisy()
    assert all(0.5 <= number <= 1.5 for number in one) and len(set(one)) > 40


def test_a_number_stays_within_its_type(messages: Messages) -> None:
    kind = "std_msgs/msg/UInt8"
    assert _sent(fault(messages, "scaled", 2, kind=kind), messages, kind, data=200).data == 255
    assert _sent(fault(messages, "inverted", kind=kind), messages, kind, data=3).data == 0
    assert _sent(fault(messages, "shifted", 0.2, kind=kind), messages, kind, data=3).data == 3


def test_what_is_not_finite_stays(messages: Messages) -> None:
    assert _sent(fault(messages, "scaled", 2), messages, FLOAT, data=float("inf")).data == float("inf")
    assert str(_sent(fault(messages, "shifted", 2), messages, FLOAT, data=float("nan")).data) == "nan"


def test_a_truth_is_negated_or_stuck(messages: Messages) -> None:
    kind = "std_msgs/msg/Bool"
    assert _sent(fault(messages, "negated", kind=kind), messages, kind, data=True).data is False
    assert _sent(fault(messages, "stuck", 1, kind=kind), messages, kind, data=False).data is True


def test_each_number_of_an_array_is_wrong(messages: Messages) -> None:
    kind = "sensor_msgs/msg/LaserScan"
    wrong = fault(messages, "scaled", 2, field="ranges", kind=kind)
    assert list(_sent(wrong, messages, kind, ranges=[1.0, float("inf"), 3.0]).ranges) == [2, float("inf"), 6]


def test_a_nested_number_is_wrong(messages: Messages) -> None:
    kind = "geometry_msgs/msg/Twist"
    wrong = fault(messages, "shifted", 2, field="linear.x", kind=kind)
    assert _sent(wrong, messages, kind).linear.x == 2


def test_a_held_message_has_its_own_time(messages: Messages) -> None:
    kind = "sensor_msgs/msg/LaserScan"
    wrong = fault(messages, "first", field="", kind=kind)
    scans = []
    for second in (1, 2):
        scan: Any = messages.get(kind)()
        scan.header.stamp.sec, scan.range_max = second, float(second)
        scans.append(from_cdr(type(scan), wrong.sent("Sender", "/number", 0, bytes(to_cdr(scan)))[0]))
    assert [(scan.header.stamp.sec, scan.range_max) for scan in scans] == [(1, 1), (2, 1)]


def test_others_are_left_alone(messages: Messages) -> None:
    data = bytes(to_cdr(messages.get(FLOAT)(data=1.0)))
    for change in ("stuck", "dropped", "delayed"):
        wrong = fault(messages, change, 2, field="data" if change == "stuck" else "")
        assert wrong.sent("Sender", "/other", 0, data) == [data]
        assert wrong.sent("Other", "/number", 0, data) == [data]
        assert wrong.visible("Other", "/number", 5) == 5
        assert not wrong.affected


def test_what_changes_nothing_does_not_count(messages: Messages) -> None:
    wrong = fault(messages, "stuck", 1)
    _sent(wrong, messages, FLOAT, data=1.0)
    assert not wrong.affected


def test_faults_of_users_are_others(messages: Messages) -> None:
    assert output_faults.of(None, messages.get) is None
    assert output_faults.of({"kind": "drop"}, messages.get) is None
    assert faults.of({"kind": "output"}) is None


def _sent(wrong: OutputFault, messages: Messages, kind: str, **fields: Any) -> Any:
    """Return a message as it arrives."""
    message_class: Any = messages.get(kind)
    return from_cdr(message_class, wrong.sent("Sender", "/number", 0, bytes(to_cdr(message_class(**fields))))[0])
