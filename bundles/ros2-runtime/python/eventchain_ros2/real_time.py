"""Nodes in real time: a simulation whose time is what a clock on the wall shows, so that execution times are real."""

from __future__ import annotations

from time import time_ns

from eventchain_ros2.simulation import Process, Simulation


class RealTime(Simulation):
    """Runs callbacks when they are due, or as soon as it can after that.

    Samples can be seen from the moment at which they are published, and a callback takes as long as it takes.
    """

    def __init__(self) -> None:
        super().__init__()
        self._start: int | None = None

    def start(self, wall_time: int) -> None:
        """Let time run, from 0 at this wall time (ns since 1970)."""
        self._start = wall_time

    def elapsed(self) -> int:
        """The time that has passed, in ns; 0 before the start."""
        return 0 if self._start is None else max(time_ns() - self._start, 0)

    @property
    def is_running(self) -> bool:
        """Whether time passes."""
        return self._start is not None and time_ns() >= self._start

    def wait(self) -> float | None:
        """Seconds until something is due; None: nothing is."""
        following = self.next_event()
        if self._start is None or following is None:
            return None
        return max((self._start + following[0] - time_ns()) / 1e9, 0.0)

    def reached(self, time: int) -> int:
        """Now, which is not before `time`."""
        return max(time, self.elapsed())

    def ended(self, process: Process) -> int:
        """Now."""
        return max(self.elapsed(), self.now)
