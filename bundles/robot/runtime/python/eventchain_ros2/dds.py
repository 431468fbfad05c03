"""Entities of `cyclonedds` in simulated time: participants, topics, readers and writers, and their policies.

They share topics with the nodes of `rclpy`: `rt/scan` here is `/scan` there, as on the wire.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Any, NamedTuple, cast

from eventchain_ros2 import context, endpoints
from eventchain_ros2.clock import Duration
from eventchain_ros2.idl import IdlStruct, prepare
from eventchain_ros2.messages import from_cdr, to_cdr
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from eventchain_ros2.simulation import Process, Sample, Simulation

INFINITY = 0x7FFFFFFFFFFFFFFF
"""The duration without an end, in ns (DDS_INFINITY)."""


@dataclass(frozen=True)
class _Named:
    name: str


@dataclass(frozen=True)
class _Reliable:
    max_blocking_time: int


@dataclass(frozen=True)
class _KeepLast:
    depth: int


@dataclass(frozen=True)
class _Deadline:
    deadline: int


@dataclass(frozen=True)
class _Liveliness:
    policy: LivelinessPolicy
    lease_duration: int


@dataclass(frozen=True)
class _DurabilityService:
    cleanup_delay: int
    history: Any
    max_samples: int
    max_instances: int
    max_samples_per_instance: int


@dataclass(frozen=True)
class _DataRepresentation:
    use_cdrv0_representation: bool = False
    use_xcdrv2_representation: bool = False


_BEST_EFFORT, _KEEP_ALL = _Named("BestEffort"), _Named("KeepAll")
_VOLATILE, _TRANSIENT_LOCAL = _Named("Volatile"), _Named("TransientLocal")


class Policy:
    """Policies of simulated readers and writers."""

    class Reliability:
        """Retransmission of lost samples."""

        BestEffort = _BEST_EFFORT
        Reliable = _Reliable

    class Durability:
        """Delivery of earlier samples to late readers."""

        Volatile = _VOLATILE
        TransientLocal = _TRANSIENT_LOCAL

    class History:
        """Number of kept samples."""

        KeepAll = _KEEP_ALL
        KeepLast = _KeepLast

    class Liveliness:
        """Assertion of a writer's liveliness."""

        @staticmethod
        def Automatic(lease_duration: int) -> _Liveliness:  # noqa: N802 - the name in cyclonedds
            """Automatic, by its process."""
            return _Liveliness(LivelinessPolicy.AUTOMATIC, lease_duration)

        @staticmethod
        def ManualByTopic(lease_duration: int) -> _Liveliness:  # noqa: N802 - the name in cyclonedds
            """By writing."""
            return _Liveliness(LivelinessPolicy.MANUAL_BY_TOPIC, lease_duration)

    Deadline = _Deadline
    DurabilityService = _DurabilityService
    DataRepresentation = _DataRepresentation


class Qos:
    """A set of policies; a later policy replaces an earlier one of the same kind."""

    def __init__(self, *policies: Any) -> None:
        self._policies = policies

    def profile(self, reliability: ReliabilityPolicy) -> QoSProfile:
        """Return the profile for matching; unset policies have the defaults of DDS.

        Args:
            reliability: the default, which differs between readers and writers (DDS 1.4, section 2.2.3).

        """
        stated: dict[str, Any] = {"reliability": reliability, "depth": 1}
        for policy in self._policies:
            stated.update(_stated(policy))
        return QoSProfile(**stated)


def _stated(policy: Any) -> dict[str, Any]:
    """Return a policy's settings for a profile; representation and blocking time have no effect here."""
    if isinstance(policy, _KeepLast):
        return {"history": HistoryPolicy.KEEP_LAST, "depth": policy.depth}
    if isinstance(policy, _Deadline):
        return {"deadline": _duration(policy.deadline)}
    if isinstance(policy, _Liveliness):
        return {"liveliness": policy.policy, "liveliness_lease_duration": _duration(policy.lease_duration)}
    if isinstance(policy, _Reliable):
        return {"reliability": ReliabilityPolicy.RELIABLE}
    if isinstance(policy, _DurabilityService | _DataRepresentation):
        return {}
    named = {
        _BEST_EFFORT: {"reliability": ReliabilityPolicy.BEST_EFFORT},
        _KEEP_ALL: {"history": HistoryPolicy.KEEP_ALL},
        _VOLATILE: {"durability": DurabilityPolicy.VOLATILE},
        _TRANSIENT_LOCAL: {"durability": DurabilityPolicy.TRANSIENT_LOCAL},
    }
    if policy not in named:
        raise TypeError(f"{policy!r} is not a policy that this runtime knows")
    return cast("dict[str, Any]", named[policy])


def _duration(nanoseconds: int) -> Duration:
    """Return a duration for a profile, where zero is infinite."""
    return Duration() if nanoseconds == INFINITY else Duration(nanoseconds=nanoseconds)


class DomainParticipant:
    """The participant of a node's entities. There is one domain, whatever its number."""

    def __init__(self, domain_id: int = 0) -> None:
        self.simulation: Simulation = context.current()
        self.process: Process = self.simulation.process_of_new_node("participant")


class Topic:
    """A topic and the type of its messages."""

    def __init__(self, domain_participant: DomainParticipant, topic_name: str, data_type: type) -> None:
        prepare(data_type)
        self.name = topic_name
        self.data_type: Any = data_type

    def ros_name(self) -> str:
        """Return the ROS 2 name of the topic, if it is a ROS 2 topic."""
        return self.name.removeprefix("rt") if self.name.startswith("rt/") else self.name


class SampleInfo(NamedTuple):
    """Sample information of a reader."""

    valid_data: bool


class DataWriter:
    """Writes messages on a topic."""

    def __init__(self, publisher_or_participant: DomainParticipant, topic: Topic, qos: Qos | None = None) -> None:
        owner, profile = publisher_or_participant, (qos or Qos()).profile(ReliabilityPolicy.RELIABLE)
        self.topic = topic
        self._simulation = owner.simulation
        self._publisher = endpoints.Publisher(
            owner.simulation, owner.process, topic.data_type, topic.ros_name(), profile
        )

    def write(self, sample: Any) -> None:
        """Write a message.

        Raises:
            TypeError: the message is of another type.
            AssertionError: a field holds a value of a wrong type or out of range.

        """
        if not isinstance(sample, self.topic.data_type):
            raise TypeError(f"{sample} is not of type {self.topic.data_type}")
        self._simulation.publish(self._publisher, to_cdr(sample))


class _Cache(endpoints.Subscription):
    """Keeps samples until the reader takes them; drops the oldest first."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.samples: deque[Sample] = deque(maxlen=self.qos_profile.capacity())

    def receive(self, sample: Sample) -> None:
        """Keep a sample."""
        self.samples.append(sample)


class DataReader:
    """Reads messages of a topic."""

    def __init__(self, subscriber_or_participant: DomainParticipant, topic: Topic, qos: Qos | None = None) -> None:
        owner, profile = subscriber_or_participant, (qos or Qos()).profile(ReliabilityPolicy.BEST_EFFORT)
        self.topic = topic
        self._cache = _Cache(owner.simulation, owner.process, topic.data_type, topic.ros_name(), self.take, profile)

    def read(self, N: int = 1) -> list[Any]:  # noqa: N803 - the name in cyclonedds
        """Return the oldest messages, at most this many, without removing them."""
        return [self._message(sample) for sample, _ in zip(self._cache.samples, range(N), strict=False)]

    def take(self, N: int = 1) -> list[Any]:  # noqa: N803 - the name in cyclonedds
        """Remove and return the oldest messages, at most this many."""
        samples = self._cache.samples
        return [self._message(samples.popleft()) for _ in range(min(N, len(samples)))]

    def _message(self, sample: Sample) -> Any:
        message = from_cdr(self.topic.data_type, sample.data)
        message.sample_info = SampleInfo(valid_data=True)
        return message


__all__ = ["INFINITY", "DataReader", "DataWriter", "DomainParticipant", "IdlStruct", "Policy", "Qos", "Topic"]
