"""Quality of service: profiles as in `rclpy.qos`, and the compatibility of offers and requests."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any

from eventchain_ros2.clock import Duration

if TYPE_CHECKING:
    from collections.abc import Iterator


class HistoryPolicy(IntEnum):
    """Number of samples kept for a busy reader."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(IntEnum):
    """Retransmission of lost samples."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(IntEnum):
    """Delivery of earlier samples to late readers."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(IntEnum):
    """Assertion of a writer's liveliness."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


BEST_AVAILABLE_DURATION = Duration(nanoseconds=2**63 - 2)
"""A deadline or lease duration that is decided by the other ends."""


class InvalidQoSProfileException(Exception):  # noqa: N818 - rclpy's name
    """The arguments of a profile contradict each other."""

    def __init__(self, *arguments: object) -> None:
        super().__init__("Invalid QoSProfile", *arguments)


class QoSProfile:
    """A quality of service profile; `depth` or `history` has to be given, all arguments by keyword."""

    __slots__ = (
        "avoid_ros_namespace_conventions",
        "deadline",
        "depth",
        "durability",
        "history",
        "lifespan",
        "liveliness",
        "liveliness_lease_duration",
        "reliability",
    )

    def __init__(self, **policies: Any) -> None:
        unknown = set(policies) - set(self.__slots__)
        if unknown:
            raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(sorted(unknown))}")
        if "history" not in policies:
            if "depth" not in policies:
                raise InvalidQoSProfileException("History and/or depth settings are required.")
            policies["history"] = HistoryPolicy.KEEP_LAST
        if policies["history"] == HistoryPolicy.KEEP_LAST and "depth" not in policies:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        self.history = HistoryPolicy(policies["history"])
        self.depth = _depth(policies.get("depth", 0))
        self.reliability = ReliabilityPolicy(policies.get("reliability", ReliabilityPolicy.RELIABLE))
        self.durability = DurabilityPolicy(policies.get("durability", DurabilityPolicy.VOLATILE))
        self.liveliness = LivelinessPolicy(policies.get("liveliness", LivelinessPolicy.SYSTEM_DEFAULT))
        self.deadline = _duration(policies.get("deadline"))
        self.lifespan = _duration(policies.get("lifespan"))
        self.liveliness_lease_duration = _duration(policies.get("liveliness_lease_duration"))
        self.avoid_ros_namespace_conventions = bool(policies.get("avoid_ros_namespace_conventions", False))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.__slots__)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"QoSProfile({', '.join(f'{name}={getattr(self, name)!s}' for name in self.__slots__)})"

    def capacity(self) -> int | None:
        """Return the number of samples kept for a busy reader of this profile; None: all."""
        return None if self.history == HistoryPolicy.KEEP_ALL else max(self.depth, 1)


def as_profile(value: QoSProfile | int) -> QoSProfile:
    """Return the profile for a `qos_profile` argument: a profile, or the depth of the default one."""
    if isinstance(value, QoSProfile):
        return value
    if isinstance(value, int):
        return QoSProfile(depth=value)
    raise TypeError(f"Expected QoSProfile or int, but received {type(value)!r}")


def _depth(value: object) -> int:
    if not isinstance(value, int):
        raise AssertionError(f"depth must be an int, not {value!r}")
    if value < 0:
        raise ValueError("depth must be greater than or equal to zero")
    return value


def _duration(value: object) -> Duration:
    if value is None:
        return Duration()
    if not isinstance(value, Duration):
        raise AssertionError(f"{value!r} is not a Duration")
    return value


def incompatible_policies(offered: QoSProfile, requested: QoSProfile) -> Iterator[str]:
    """Return the names of the policies whose offer does not satisfy the request (DDS 1.4, section 2.2.3).

    What is best available satisfies and is satisfied: it is decided by the other ends.
    """
    if requested.reliability not in _ASKS_LITTLE and offered.reliability == ReliabilityPolicy.BEST_EFFORT:
        yield "RELIABILITY"
    if requested.durability == DurabilityPolicy.TRANSIENT_LOCAL and offered.durability not in _KEEPS:
        yield "DURABILITY"
    if _longer(offered.deadline, requested.deadline):
        yield "DEADLINE"
    weaker = requested.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC and offered.liveliness not in _ASSERTS
    if weaker or _longer(offered.liveliness_lease_duration, requested.liveliness_lease_duration):
        yield "LIVELINESS"


_ASKS_LITTLE = (ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.BEST_AVAILABLE)
_KEEPS = (DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.BEST_AVAILABLE)
_ASSERTS = (LivelinessPolicy.MANUAL_BY_TOPIC, LivelinessPolicy.BEST_AVAILABLE)


def _longer(offered: Duration, requested: Duration) -> bool:
    """Return whether the offered period is longer than the requested one; zero is infinite."""
    if not requested.nanoseconds or BEST_AVAILABLE_DURATION in (offered, requested):
        return False
    return not offered.nanoseconds or offered.nanoseconds > requested.nanoseconds


class QoSCompatibility(IntEnum):
    """Result of `qos_check_compatible`."""

    OK = 0
    WARNING = 1
    ERROR = 2


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return whether a publisher and a subscription match, and if not, why."""
    policies = list(incompatible_policies(publisher_qos, subscription_qos))
    if not policies:
        return QoSCompatibility.OK, ""
    return QoSCompatibility.ERROR, "; ".join(f"ERROR: incompatible {policy}" for policy in policies)


qos_profile_default = QoSProfile(depth=10)
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    deadline=BEST_AVAILABLE_DURATION,
    liveliness_lease_duration=BEST_AVAILABLE_DURATION,
)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class QoSPresetProfiles(Enum):
    """The named profiles."""

    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile of a name such as `sensor_data`."""
        return cls[name.upper()].value
