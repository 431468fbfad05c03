"""Events of participants on the wire, and waiting for them."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable
from time import monotonic_ns
from typing import Any

import pytest
from eventchain_ros2.clock import Duration
from eventchain_ros2.dds_endpoints import in_slices
from eventchain_ros2.dds_entities import ClosedError, Participant, WaitSet
from eventchain_ros2.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from wire import (
    MILLISECOND,
    PATIENCE,
    SECOND,
    STRING,
    TEXT,
    connected,
    wait_until,
)

BEST_EFFORT = ReliabilityPolicy.BEST_EFFORT


@pytest.mark.parametrize(
    ("offered", "requested", "policy"),
    [
        ({"reliability": BEST_EFFORT}, {}, "RELIABILITY"),
        ({}, {"durability": DurabilityPolicy.TRANSIENT_LOCAL}, "DURABILITY"),
        ({"deadline": Duration(seconds=2)}, {"deadline": Duration(seconds=1)}, "DEADLINE"),
        ({}, {"deadline": Duration(seconds=1)}, "DEADLINE"),
        ({}, {"liveliness": LivelinessPolicy.MANUAL_BY_TOPIC}, "LIVELINESS"),
        ({}, {"liveliness_lease_duration": Duration(seconds=9)}, "LIVELINESS"),
    ],
)
def test_both_sides_know_the_policy_that_does_not_match(
    participants: tuple[Participant, Participant], offered: dict[str, Any], requested: dict[str, Any], policy: str
) -> None:
    writer = participants[0].writer("/topic", STRING, QoSProfile(depth=1, **offered))
    waiting = WaitSet(participants[1])
    reader = participants[1].reader("/topic", STRING, QoSProfile(depth=1, **requested))
    waiting.attach_events(reader)
    assert waiting.wait(PATIENCE * SECOND)
    assert reader.incompatible() == policy
    assert reader.incompatible() is None
    names: list[str | None] = []
    wait_until(lambda: names.append(writer.incompatible()) or names[-1], "the writer's side")
    assert names[-1] == policy
    assert (writer.matched(), reader.matched()) == (0, 0)


def test_matching_policies_are_no_event(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    assert (writer.incompatible(), reader.incompatible()) == (None, None)
    assert (writer.missed_deadlines(), reader.missed_deadlines()) == (0, 0)
    assert (writer.lost_liveliness(), reader.lost_writers()) == (0, 0)


def test_both_sides_know_of_a_missed_deadline(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants, profile=QoSProfile(depth=1, deadline=Duration(seconds=0.05)))
    writer.write(TEXT)
    missed = [0, 0]

    def both_missed() -> bool:
        missed[0] += writer.missed_deadlines()
        missed[1] += reader.missed_deadlines()
        return all(missed)

    wait_until(both_missed, "missed deadlines")


def test_both_sides_know_of_a_writer_that_does_not_show_up(participants: tuple[Participant, Participant]) -> None:
    manual = LivelinessPolicy.MANUAL_BY_TOPIC
    lease = Duration(seconds=0.05)
    profile = QoSProfile(depth=1, liveliness=manual, liveliness_lease_duration=lease)
    writer, reader = connected(participants, profile=profile)
    writer.write(TEXT)
    lost = [0, 0]

    def both_lost() -> bool:
        lost[0] += writer.lost_liveliness()
        lost[1] += reader.lost_writers()
        return all(lost)

    wait_until(both_lost, "lost liveliness")


def test_a_wait_ends_with_a_sample_or_with_the_time(participants: tuple[Participant, Participant]) -> None:
    writer, reader = connected(participants)
    waiting = WaitSet(participants[1])
    waiting.attach(reader)
    started = monotonic_ns()
    assert not waiting.wait(250 * MILLISECOND)
    assert monotonic_ns() - started >= 250 * MILLISECOND
    writer.write(TEXT, 1)
    assert waiting.wait(PATIENCE * SECOND)
    assert waiting.wait(0), "until it is taken"
    reader.take()
    assert not waiting.wait(0)


def once_it_waits(act: Callable[[], None]) -> None:
    """Run an action while the main thread is in a wait."""
    main = threading.main_thread().ident

    def waits() -> bool:
        frame = sys._current_frames().get(main or 0)
        while frame is not None and frame.f_code is not in_slices.__code__:
            frame = frame.f_back
        return frame is not None

    wait_until(waits, "the wait")
    act()


def interrupt_a_wait() -> None:
    once_it_waits(lambda: os.kill(os.getpid(), signal.SIGUSR1))


def test_a_wait_can_be_ended_from_another_thread(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    thread = threading.Thread(target=lambda: once_it_waits(waiting.wake))
    thread.start()
    assert waiting.wait(None)
    thread.join()
    assert not waiting.wait(0), "once only"


def test_a_wait_lets_signal_handlers_run(participants: tuple[Participant, Participant]) -> None:
    def interrupt(*_: object) -> None:
        raise InterruptedError

    former = signal.signal(signal.SIGUSR1, interrupt)
    waiting = WaitSet(participants[0])
    thread = threading.Thread(target=interrupt_a_wait)
    try:
        with pytest.raises(InterruptedError):
            thread.start()
            waiting.wait(None)
    finally:
        thread.join()
        signal.signal(signal.SIGUSR1, former)


def test_a_signal_handler_can_end_the_wait_it_interrupts(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    former = signal.signal(signal.SIGUSR1, lambda *_: waiting.wake())
    thread = threading.Thread(target=interrupt_a_wait)
    try:
        thread.start()
        assert waiting.wait(PATIENCE * SECOND)
    finally:
        thread.join()
        signal.signal(signal.SIGUSR1, former)


def test_closing_ends_a_wait(participants: tuple[Participant, Participant]) -> None:
    waiting = WaitSet(participants[0])
    thread = threading.Thread(target=lambda: once_it_waits(participants[0].close))
    thread.start()
    with pytest.raises(ClosedError):
        waiting.wait(None)
    thread.join()
