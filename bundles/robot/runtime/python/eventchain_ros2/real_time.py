"""Nodes in real time: a simulation whose time is that of a clock, so that execution times are real.

The clock is the system's monotonic one, which nobody sets: all processes of this machine read the same time from it.
"""

from __future__ import annotations

from time import monotonic_ns

from eventchain_ros2.simulation import Process, Simulation


class RealTime(Simulation):
    """Runs callbacks when they are due, or as soon as it can after that.

    Samples can be seen from the moment at which they are published, and a callback takes as long as it takes.
    """

    def __init__(self) -> None:
        super().__init__()
        self.late = 0
        """How long after its start it was told to start, in ns."""
        self.is_over = False
        self._start: int | None = None

    def start(self, time: int) -> None:
        """Let time run, from 0 at this time of the monotonic clock, in ns."""
        self._start = time
        self.late = max(monotonic_ns() - time, 0)

    def end(self) -> None:
        """Let nothing happen any more."""
        self.is_over = True

    def elapsed(self) -> int:
        """The time that has passed, in ns; 0 before the start."""
        return 0 if self._start is None else max(monotonic_ns() - self._start, 0)

    @property
    def is_running(self) -> bool:
        """Whether time passes."""
        return not self.is_over and self._start is not None and monotonic_ns() >= self._start

    def wait(self, *, has_samples: bool) -> float | None:
        """Seconds until something is due; None: nothing is.

        Args:
            has_samples: whether samples wait to be delivered.

        """
        if self._start is None or self.is_over:
            return None
        following = (0,) if has_samples else self.next_event()
        return None if following is None else max((self._start + following[0] - monotonic_ns()) / 1e9, 0.0)

    def reached(self, time: int) -> int:
        """Now, which is not before `time`."""
        return max(time, self.elapsed())

    def ended(self, process: Process) -> int:
        """Now."""
        return max(self.elapsed(), self.now)
