"""Publishers, subscriptions and timers of nodes, as in rclpy."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

from eventchain_ros2.clock import Duration
from eventchain_ros2.messages import Message, from_cdr, to_cdr, type_name
from eventchain_ros2.qos import DurabilityPolicy, QoSProfile
from eventchain_ros2.simulation import Process, Sample, Simulation
from eventchain_ros2.simulation import Subscription as Receiver


class ROSInterruptException(Exception):  # noqa: N818 - rclpy's name
    """The nodes were shut down while something waited."""


class Publisher:
    """Publishes messages of one type on a topic."""

    owner = ""
    """The client or server of a service that it belongs to, as others on DDS see it; empty: none."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    def __init__(
        self, simulation: Simulation, process: Process, message_class: type, topic: str, qos_profile: QoSProfile
    ) -> None:
        self._simulation = simulation
        self.process = process
        self.msg_type = message_class
        self.type_name = type_name(message_class)
        self.topic = simulation.topic(topic)
        self.matched: list[Receiver] = []
        self.decide(qos_profile)
        simulation.add_publisher(self)

    def decide(self, qos_profile: QoSProfile) -> None:
        """Set the profile, before anything is published with it."""
        self.qos_profile = qos_profile
        transient = qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
        self.retained: deque[Sample] = deque(maxlen=qos_profile.capacity() if transient else 0)

    @property
    def topic_name(self) -> str:
        """Return the full name of the topic."""
        return self.topic.name

    def publish(self, message: Any) -> None:
        """Publish a message, or the CDR bytes of one.

        Raises:
            TypeError: the message is of another type.
            AssertionError: a field holds a value of a wrong type or out of range.

        """
        if isinstance(message, Message) and type(message) is self.msg_type:
            self._simulation.publish(self, to_cdr(message))
        elif isinstance(message, bytes | bytearray | memoryview):
            self._simulation.publish(self, bytes(message))
        else:
            raise TypeError(f"Expected {self.msg_type}, got {type(message)}")

    def decodes(self, data: bytes | bytearray | memoryview) -> bool:
        """Return whether these bytes are the canonical encoding of a message of its type."""
        try:
            return to_cdr(from_cdr(self.msg_type, data)) == bytes(data)
        except (ValueError, AssertionError, TypeError, OverflowError):
            return False

    def get_subscription_count(self) -> int:
        """Return the number of matched subscriptions."""
        return sum(getattr(each, "count", 1) for each in self.matched)

    def wait_for_all_acked(self, timeout: Duration | None = None) -> bool:
        """Return whether all reliable subscriptions have acknowledged everything, within a time; None: no limit."""
        return self._simulation.acknowledged(self, None if timeout is None else timeout.nanoseconds)

    def assert_liveliness(self) -> None:
        """Assert the liveliness of this publisher."""
        self._simulation.assert_liveliness(self)

    def destroy(self) -> None:
        """Stop publishing."""
        if self in self.topic.publishers:
            self.topic.publishers.remove(self)
            self._simulation.remove(self)
        self.matched.clear()


class Subscription:
    """Runs a callback for each sample on a topic."""

    owner = ""
    """As that of a publisher."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    def __init__(
        self,
        simulation: Simulation,
        process: Process,
        message_class: type,
        topic: str,
        callback: Callable[[Any], object],
        qos_profile: QoSProfile,
        *,
        raw: bool = False,
    ) -> None:
        self._simulation = simulation
        self.process = process
        self.msg_type = message_class
        self.type_name = type_name(message_class)
        self.topic = simulation.topic(topic)
        self.callback = callback
        self.raw = raw
        self.decide(qos_profile)
        simulation.add_subscription(self)

    def decide(self, qos_profile: QoSProfile) -> None:
        """Set the profile, before anything is received with it."""
        self.qos_profile = qos_profile

    @property
    def topic_name(self) -> str:
        """Return the full name of the topic."""
        return self.topic.name

    def receive(self, sample: Sample) -> None:
        """Run the callback. Each subscription decodes its own copy, since callbacks may change messages."""
        result = self.callback(bytes(sample.data) if self.raw else from_cdr(self.msg_type, sample.data))
        if result is not None:
            _follow(self, result)

    def get_publisher_count(self) -> int:
        """Return the number of matched publishers."""
        return self._simulation.publishers_of(self)

    def destroy(self) -> None:
        """Stop receiving."""
        if self in self.topic.subscriptions:
            self.topic.subscriptions.remove(self)
            self._simulation.remove(self)
        for publisher in self.topic.publishers:
            if self in publisher.matched:
                publisher.matched.remove(self)
        self.process.inbox = [entry for entry in self.process.inbox if entry[0] is not self]


class GuardCondition:
    """Runs a callback when it is triggered, once for all triggers that come before it runs."""

    def __init__(self, simulation: Simulation, process: Process, callback: Callable[[], object]) -> None:
        self._simulation = simulation
        self.process = process
        self.callback = callback
        self._is_triggered = False
        self._is_destroyed = False

    def trigger(self) -> None:
        """Let the executor run the callback."""
        if not self._is_triggered and not self._is_destroyed:
            self._is_triggered = True
            self._simulation.call(self.process, self._run)

    def _run(self) -> None:
        self._is_triggered = False
        if not self._is_destroyed:
            _follow(self, self.callback())

    def destroy(self) -> None:
        """Do not run the callback any more."""
        self._is_destroyed = True


class Rate:
    """Sleeps until the next period, for loops beside the executor."""

    def __init__(self, simulation: Simulation, period: int, now: Callable[[], int]) -> None:
        self._simulation = simulation
        self._period = period
        self._now = now
        self._due = now() + period

    def sleep(self) -> None:
        """Wait for the end of the period; those that have passed are skipped.

        Raises:
            ROSInterruptException: the nodes were shut down meanwhile.
            RuntimeError: a callback wants to wait in simulated time.

        """
        left = self._due - self._now()
        if left > 0 and not self._simulation.sleep(left):
            raise ROSInterruptException("the nodes were shut down during a sleep")
        self._due += (1 + max(0, self._now() - self._due) // self._period) * self._period

    def destroy(self) -> None:
        """Do nothing: it needs nothing."""


class Timer:
    """Runs a callback periodically. Missed periods are skipped as in rcl, without a burst."""

    def __init__(
        self,
        simulation: Simulation,
        process: Process,
        period: int,
        callback: Callable[[], object],
        *,
        autostart: bool = True,
    ) -> None:
        self._simulation = simulation
        self.process = process
        self.timer_period_ns = period
        self.callback = callback
        self.index = process.timers
        process.timers += 1
        self.token = 0
        self._canceled = not autostart
        self.due = simulation.first_firing(process, period)
        if autostart:
            simulation.add_timer(self)

    def advance(self, now: int) -> None:
        """Advance to the next period that has not passed (rcl_timer_call)."""
        self.due += self.timer_period_ns
        if self.due < now:
            behind = now - self.due
            self.due += -(-behind // self.timer_period_ns) * self.timer_period_ns

    def run(self, _: None) -> None:
        """Run the callback."""
        result = self.callback()
        if result is not None:
            _follow(self, result)

    def cancel(self) -> None:
        """Stop, until `reset`."""
        self._canceled = True
        self.token += 1

    def reset(self) -> None:
        """Restart the period now."""
        self._canceled = False
        self.token += 1
        self.due = self._simulation.now + self.timer_period_ns
        self._simulation.add_timer(self)

    def is_canceled(self) -> bool:
        """Return whether the timer is stopped."""
        return self._canceled

    def is_ready(self) -> bool:
        """Return whether the timer is due."""
        return not self._canceled and self.due <= self._simulation.now

    def time_since_last_call(self) -> int:
        """Return the nanoseconds since the last call, or since the start without one."""
        return self._simulation.now - (self.due - self.timer_period_ns)

    def time_until_next_call(self) -> int | None:
        """Return the nanoseconds until the timer is due; None when it is stopped."""
        return None if self._canceled else self.due - self._simulation.now

    def destroy(self) -> None:
        """Stop permanently."""
        self.cancel()


def _follow(endpoint: Any, result: object) -> None:
    """Let a callback go on that is a coroutine; few are, so that most hosts start without tasks."""
    from eventchain_ros2 import tasks

    tasks.follow(endpoint._simulation, endpoint.process, result)
