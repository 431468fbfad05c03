"""Nodes in real time: a simulation driven by a clock, so that execution times are real.

The clock is the system's monotonic one, which cannot be set and is the same for all processes of this machine.
"""

from __future__ import annotations

from time import monotonic_ns

from eventchain_ros2.simulation import Process, Simulation


class RealTime(Simulation):
    """Runs callbacks when they are due, or as soon as possible after that.

    Samples are visible as soon as they are published, and callbacks take their actual time.
    """

    def __init__(self) -> None:
        super().__init__()
        self.late = 0
        """Delay between its start and the order to start, in ns."""
        self.is_over = False
        self._start: int | None = None

    def start(self, time: int) -> None:
        """Start the time with 0 at this time of the monotonic clock, in ns."""
        self._start = time
        self.late = max(monotonic_ns() - time, 0)

    def end(self) -> None:
        """Stop all further events."""
        self.is_over = True

    def elapsed(self) -> int:
        """Return the elapsed time, in ns; 0 before the start."""
        return 0 if self._start is None else max(monotonic_ns() - self._start, 0)

    @property
    def is_running(self) -> bool:
        """Return whether time is running."""
        return not self.is_over and self._start is not None and monotonic_ns() >= self._start

    def wait(self, *, has_samples: bool) -> float | None:
        """Return the seconds until the next event; None: there is none.

        Args:
            has_samples: whether samples wait to be delivered.

        """
        if self._start is None or self.is_over:
            return None
        following = (0,) if has_samples else self.next_event()
        return None if following is None else max((self._start + following[0] - monotonic_ns()) / 1e9, 0.0)

    def reached(self, time: int) -> int:
        """Return the current time, which is not before `time`."""
        return max(time, self.elapsed())

    def ended(self, process: Process) -> int:
        """Return the current time."""
        return max(self.elapsed(), self.now)
