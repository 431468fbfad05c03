"""Quality of service: which ends match, and what is best available."""

from __future__ import annotations

from typing import Any

import pytest
from eventchain_ros2.best_available import for_anyone
from eventchain_ros2.simulation import Simulation
from rclpy.duration import Duration
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    InvalidQoSProfileException,
    LivelinessPolicy,
    QoSCompatibility,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    qos_check_compatible,
    qos_profile_best_available,
    qos_profile_sensor_data,
)
from recorder import MILLISECOND, Recorder, number

BEST_EFFORT = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.mark.parametrize(
    ("offered", "requested", "policy"),
    [
        (BEST_EFFORT, 10, "RELIABILITY"),
        (10, LATCHED, "DURABILITY"),
        (10, QoSProfile(depth=1, deadline=Duration(seconds=0.1)), "DEADLINE"),
        (10, QoSProfile(depth=1, liveliness_lease_duration=Duration(seconds=1)), "LIVELINESS"),
    ],
)
@pytest.mark.parametrize("publisher_first", [True, False])
def test_incompatible_qos_delivers_nothing_and_warns(
    simulation: Simulation,
    capsys: pytest.CaptureFixture[str],
    offered: Any,
    requested: Any,
    policy: str,
    publisher_first: bool,
) -> None:
    node = Recorder()
    if publisher_first:
        publisher = node.advertise("/number", offered)
        node.subscribe("/number", requested)
    else:
        node.subscribe("/number", requested)
        publisher = node.advertise("/number", offered)
    publisher.publish(number(1.0))
    simulation.advance(MILLISECOND)
    assert node.received == []
    (warning,) = simulation.warnings
    assert (warning.id, warning.topic) == ("qos.incompatible", "/number")
    assert "'/number'" in capsys.readouterr().err
    assert warning.message.endswith(f"Last incompatible policy: {policy}")


@pytest.mark.parametrize(
    ("offered", "requested"),
    [
        (10, BEST_EFFORT),
        (10, qos_profile_sensor_data),
        (LATCHED, 10),
        (QoSProfile(depth=1, deadline=Duration(seconds=0.1)), QoSProfile(depth=1, deadline=Duration(seconds=0.1))),
        (QoSPresetProfiles.SYSTEM_DEFAULT.value, 10),
    ],
)
def test_an_offer_that_satisfies_the_request_delivers(simulation: Simulation, offered: Any, requested: Any) -> None:
    node = Recorder()
    node.subscribe("/number", requested)
    node.advertise("/number", offered).publish(number(1.0))
    simulation.advance(MILLISECOND)
    assert node.received == [(0.0, 1.0)]
    assert simulation.warnings == []


STRICT = QoSProfile(
    depth=1,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    deadline=Duration(seconds=0.1),
)


def policies(endpoint: Any) -> list[str]:
    profile = endpoint.qos_profile
    names = [profile.reliability.name, profile.durability.name, profile.liveliness.name]
    return [*names, f"{profile.deadline.nanoseconds / MILLISECOND:.0f}"]


@pytest.mark.parametrize(
    ("others", "subscription", "publisher"),
    [
        ([10], "RELIABLE VOLATILE AUTOMATIC 0", "RELIABLE TRANSIENT_LOCAL AUTOMATIC 0"),
        ([10, BEST_EFFORT], "BEST_EFFORT VOLATILE AUTOMATIC 0", "RELIABLE TRANSIENT_LOCAL AUTOMATIC 0"),
        ([STRICT], "RELIABLE TRANSIENT_LOCAL MANUAL_BY_TOPIC 100", "RELIABLE TRANSIENT_LOCAL MANUAL_BY_TOPIC 100"),
        ([STRICT, 10], "RELIABLE VOLATILE AUTOMATIC 100", "RELIABLE TRANSIENT_LOCAL MANUAL_BY_TOPIC 100"),
        ([], "RELIABLE TRANSIENT_LOCAL MANUAL_BY_TOPIC 0", "RELIABLE TRANSIENT_LOCAL AUTOMATIC 0"),
        ([qos_profile_best_available], "RELIABLE TRANSIENT_LOCAL AUTOMATIC 0", "RELIABLE TRANSIENT_LOCAL AUTOMATIC 0"),
    ],
)
@pytest.mark.parametrize("others_first", [True, False])
def test_what_is_best_available_is_decided_by_all_other_ends(
    simulation: Simulation, others: list[Any], subscription: str, publisher: str, others_first: bool
) -> None:
    node, found = Recorder(), []
    for make, other in ((node.subscribe, node.advertise), (node.advertise, node.subscribe)):
        topic = f"/{make.__name__}"
        before = [other(topic, each) for each in others] if others_first else []
        found.append(make(topic, qos_profile_best_available))
        after = [] if others_first else [other(topic, each) for each in others]
        assert len(before + after) == len(others)
    simulation.settle()
    assert [" ".join(policies(each)) for each in found] == [subscription, publisher]


@pytest.mark.parametrize("other", [10, BEST_EFFORT, LATCHED, STRICT, qos_profile_best_available])
def test_what_suits_anyone_matches_every_end(other: Any) -> None:
    profile = QoSProfile(depth=other) if isinstance(other, int) else other
    subscription = for_anyone(qos_profile_best_available, publishes=False)
    assert qos_check_compatible(profile, subscription) == (QoSCompatibility.OK, "")
    publisher = for_anyone(qos_profile_best_available, publishes=True)
    assert qos_check_compatible(publisher, profile)[1] in ("", "ERROR: incompatible DEADLINE")


def test_best_available_ends_exchange_samples(simulation: Simulation) -> None:
    node = Recorder()
    node.subscribe("/number", qos_profile_best_available)
    gone = node.create_subscription(type(number(0.0)), "/number", node.receive, qos_profile_best_available)
    publisher = node.advertise("/number", BEST_EFFORT)
    publisher.publish(number(1.0))
    node.destroy_subscription(gone)
    simulation.advance(MILLISECOND)
    node.advertise("/late", qos_profile_best_available).publish(number(2.0))
    simulation.advance(2 * MILLISECOND)
    node.subscribe("/late", LATCHED)
    simulation.advance(3 * MILLISECOND)
    assert [value for _, value in node.received] == [1.0, 2.0]
    assert simulation.warnings == []
    assert qos_check_compatible(BEST_EFFORT, qos_profile_best_available)[0] == QoSCompatibility.OK
    assert qos_check_compatible(qos_profile_best_available, STRICT)[0] == QoSCompatibility.OK


def test_late_readers_get_the_last_samples_of_a_transient_local_writer(simulation: Simulation) -> None:
    node = Recorder()
    publisher = node.advertise("/number", LATCHED)
    for value in (1.0, 2.0, 3.0):
        publisher.publish(number(value))
    simulation.advance(MILLISECOND)
    late, volatile = Recorder("late"), Recorder("volatile")
    late.subscribe("/number", LATCHED)
    volatile.subscribe("/number")
    simulation.advance(2 * MILLISECOND)
    assert late.received == [(1.0, 2.0), (1.0, 3.0)]
    assert volatile.received == []


def test_a_profile_needs_a_depth_or_a_history() -> None:
    assert QoSProfile(depth=3).history == HistoryPolicy.KEEP_LAST
    for arguments in ({}, {"history": HistoryPolicy.KEEP_LAST}):
        with pytest.raises(InvalidQoSProfileException):
            QoSProfile(**arguments)
    with pytest.raises(AssertionError, match="deepth"):
        QoSProfile(deepth=3)


@pytest.mark.parametrize("profile", ["10", 10.0, None])
def test_a_profile_is_a_profile_or_a_depth(simulation: Simulation, profile: Any) -> None:
    with pytest.raises(TypeError, match="Expected QoSProfile or int"):
        Recorder().advertise("/number", profile)
