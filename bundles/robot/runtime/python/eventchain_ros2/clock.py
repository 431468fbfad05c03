"""Time, durations and clocks as in `rclpy`; every clock shows the simulated time."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import Any, ClassVar

NANOSECONDS_PER_SECOND = 1_000_000_000


class ClockType(IntEnum):
    """Kinds of clocks; times of different kinds cannot be compared."""

    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class Duration:
    """A span of time in nanoseconds."""

    __slots__ = ("nanoseconds",)

    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0) -> None:
        self.nanoseconds = int(seconds * NANOSECONDS_PER_SECOND) + int(nanoseconds)

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self.nanoseconds})"

    def __eq__(self, other: object) -> bool:
        return self.nanoseconds == other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __lt__(self, other: Duration) -> bool:
        return self.nanoseconds < other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __le__(self, other: Duration) -> bool:
        return self.nanoseconds <= other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.nanoseconds)

    def to_msg(self) -> Any:
        """Convert to `builtin_interfaces/msg/Duration`."""
        from builtin_interfaces.msg import Duration as DurationMessage  # type: ignore[import-not-found]

        seconds, nanoseconds = divmod(self.nanoseconds, NANOSECONDS_PER_SECOND)
        return DurationMessage(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, message: Any) -> Duration:
        """Convert from `builtin_interfaces/msg/Duration`."""
        return cls(nanoseconds=message.sec * NANOSECONDS_PER_SECOND + message.nanosec)


class Time:
    """A point in time, in nanoseconds since the start of its clock."""

    __slots__ = ("clock_type", "nanoseconds")

    def __init__(
        self, *, seconds: float = 0, nanoseconds: float = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if seconds < 0 or nanoseconds < 0:
            raise ValueError("Seconds and nanoseconds values must not be negative")
        self.nanoseconds = int(seconds * NANOSECONDS_PER_SECOND) + int(nanoseconds)
        self.clock_type = clock_type

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return whole seconds, and the nanoseconds of the second."""
        return divmod(self.nanoseconds, NANOSECONDS_PER_SECOND)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self.nanoseconds}, clock_type={self.clock_type.name})"

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        return Time(nanoseconds=self.nanoseconds + other.nanoseconds, clock_type=self.clock_type)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Time):
            self._require_same_clock(other)
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        if isinstance(other, Duration):
            return Time(nanoseconds=self.nanoseconds - other.nanoseconds, clock_type=self.clock_type)
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Time):
            return NotImplemented
        self._require_same_clock(other)
        return self.nanoseconds == other.nanoseconds

    def __lt__(self, other: Time) -> bool:
        self._require_same_clock(other)
        return self.nanoseconds < other.nanoseconds

    def __le__(self, other: Time) -> bool:
        self._require_same_clock(other)
        return self.nanoseconds <= other.nanoseconds

    def __hash__(self) -> int:
        return hash(self.nanoseconds)

    def _require_same_clock(self, other: Time) -> None:
        if not isinstance(other, Time) or self.clock_type != other.clock_type:
            raise TypeError("Can't compare times with different clock types")

    def to_msg(self) -> Any:
        """Convert to `builtin_interfaces/msg/Time`."""
        import builtin_interfaces.msg  # type: ignore[import-not-found]

        # `from ... import` would search the module for submodules, each time.
        seconds, nanoseconds = self.seconds_nanoseconds()
        return builtin_interfaces.msg.Time(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, message: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Convert from `builtin_interfaces/msg/Time`."""
        nanoseconds = message.sec * NANOSECONDS_PER_SECOND + message.nanosec
        return cls(nanoseconds=nanoseconds, clock_type=clock_type)


class Clock:
    """A clock. Every kind shows the simulated time, so that runs are reproducible.

    Args:
        clock_type: what `now` says of its times.
        now: returns the time of the clock's node, in ns; None: the clock is without a node.

    """

    without_node: ClassVar[Callable[[], int] | None] = None
    """Returns the time of the running callback, in ns; None as long as nothing runs."""
    sleep: ClassVar[Callable[[int], bool] | None] = None
    """Lets a number of ns pass, and returns whether nodes still run."""

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME, now: Callable[[], int] | None = None) -> None:
        self._now = now
        self.clock_type = clock_type

    def now(self) -> Time:
        """Return the simulated time; within a callback it is that of the callback's start.

        Raises:
            RuntimeError: the clock is without a node, and nothing runs.

        """
        now = self._now or Clock.without_node
        if now is None:
            raise RuntimeError("a clock without a node shows the simulated time: call rclpy.init() first")
        return Time(nanoseconds=now(), clock_type=self.clock_type)

    def sleep_for(self, rel_time: Duration, context: object = None) -> bool:
        """Let this time pass, without callbacks of this thread; return false if nodes are shut down.

        Raises:
            RuntimeError: nothing runs, or a callback wants to wait in simulated time.

        """
        if Clock.sleep is None:
            raise RuntimeError("time passes after rclpy.init() only")
        return Clock.sleep(rel_time.nanoseconds)

    def sleep_until(self, until: Time, context: object = None) -> bool:
        """As `sleep_for`, until a time of this clock."""
        return self.sleep_for(until - self.now())


class ROSClock(Clock):
    """A clock of `ClockType.ROS_TIME`."""

    def __init__(self, *, now: Callable[[], int] | None = None) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME, now=now)
