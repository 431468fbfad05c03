"""Conversion of ROS 2 profiles to DDS policies, as in ROS 2's middleware."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from eventchain_ros2 import cyclone
from eventchain_ros2.clock import Duration
from eventchain_ros2.cyclone import INFINITY
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

LONGEST_BLOCK = 100_000_000
"""Time that one native call may take, in ns: Python sees signals only between calls."""

_XCDR1 = 0
_MANUAL_BY_TOPIC = 2
_IGNORE_PARTICIPANT = 1
_UNLIMITED = -1
_POLICIES = {
    2: "DURABILITY",
    3: "PRESENTATION",
    4: "DEADLINE",
    5: "LATENCY_BUDGET",
    6: "OWNERSHIP",
    8: "LIVELINESS",
    10: "PARTITION",
    11: "RELIABILITY",
    12: "DESTINATION_ORDER",
    24: "TYPE_CONSISTENCY_ENFORCEMENT",
    25: "DATA_REPRESENTATION",
}


def policy_name(identifier: int) -> str:
    """Return the name of a policy that did not match."""
    return _POLICIES.get(identifier, f"policy {identifier}")


@contextmanager
def dds_qos(profile: QoSProfile, user_data: bytes, *, ignore_own: bool = False) -> Iterator[int]:
    """Provide the `dds_qos_t` of a writer or reader with this profile, for the length of the block.

    Args:
        profile: the policies.
        user_data: user data for other participants.
        ignore_own: whether a reader ignores writers of its own participant.

    """
    library = cyclone.load()
    made = library.dds_create_qos()
    try:
        history = _history(profile)
        reliable = profile.reliability != ReliabilityPolicy.BEST_EFFORT
        library.dds_qset_reliability(made, int(reliable), LONGEST_BLOCK if reliable else 0)
        library.dds_qset_history(made, *history)
        transient = profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
        library.dds_qset_durability(made, int(transient))
        if transient:
            library.dds_qset_durability_service(made, 0, *history, _UNLIMITED, _UNLIMITED, _UNLIMITED)
        library.dds_qset_deadline(made, _nanoseconds(profile.deadline))
        library.dds_qset_lifespan(made, _nanoseconds(profile.lifespan))
        manual = profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC
        library.dds_qset_liveliness(
            made, _MANUAL_BY_TOPIC if manual else 0, _nanoseconds(profile.liveliness_lease_duration)
        )
        library.dds_qset_data_representation(made, 1, (ctypes.c_int16 * 1)(_XCDR1))
        library.dds_qset_writer_data_lifecycle(made, False)
        library.dds_qset_ignorelocal(made, _IGNORE_PARTICIPANT if ignore_own else 0)
        library.dds_qset_userdata(made, user_data, len(user_data))
        yield made
    finally:
        library.dds_delete_qos(made)


def _history(profile: QoSProfile) -> tuple[int, int]:
    if profile.history == HistoryPolicy.KEEP_ALL:
        return 1, _UNLIMITED
    return 0, max(profile.depth, 1)


def _nanoseconds(duration: Duration) -> int:
    """Return a duration, which is infinite for zero."""
    return min(duration.nanoseconds, INFINITY) or INFINITY


def announced_profile(qos: int) -> QoSProfile:
    """Return the policies of an announced writer or reader that others have to match."""
    library = cyclone.load()
    kind, time = ctypes.c_int32(), ctypes.c_int64()
    reliable = library.dds_qget_reliability(qos, kind, time) and kind.value == 1
    transient = library.dds_qget_durability(qos, kind) and kind.value >= 1
    deadline = time.value if library.dds_qget_deadline(qos, time) else INFINITY
    manual = library.dds_qget_liveliness(qos, kind, time) and kind.value == _MANUAL_BY_TOPIC
    lease = time.value if library.dds_qget_liveliness(qos, kind, time) else INFINITY
    return QoSProfile(
        depth=1,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if transient else DurabilityPolicy.VOLATILE,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC if manual else LivelinessPolicy.AUTOMATIC,
        deadline=_duration(deadline),
        liveliness_lease_duration=_duration(lease),
    )


def _duration(nanoseconds: int) -> Duration:
    """Return a duration of DDS, which is zero for an infinite one."""
    return Duration(nanoseconds=0 if nanoseconds >= INFINITY else nanoseconds)


def user_data(qos: int) -> dict[str, str]:
    """Return the `key=value;` pairs that ROS 2 puts into the user data of its entities."""
    library = cyclone.load()
    value, size = ctypes.POINTER(ctypes.c_char)(), ctypes.c_size_t()
    if not library.dds_qget_userdata(qos, value, size) or not value:
        return {}
    content: Any = value[: size.value]  # bytes, since the elements are of type char
    text = content.decode(errors="replace")
    library.dds_free(value)
    pairs = (part.partition("=") for part in text.split(";"))
    return {key: rest for key, equals, rest in pairs if equals}
