"""Agenda of a simulation: its coming events and processes, in simulated time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from heapq import heappush
from typing import Any, NamedTuple

from eventchain_ros2.processes import Process, Publisher, ServicePeers

SAMPLE, TIMER = 0, 1
"""Ranks of simultaneous events."""

WAITS = (
    "in simulated time a callback or a constructor cannot wait, since nothing happens until it has returned: "
    "use a timer, or `await` a future in an `async` callback"
)


class Event(NamedTuple):
    """An event. Events are ordered, and `number` is unique, so that actions are never compared.

    `process` and `timer` are the indices of a timer that fires, and 0 for samples.
    """

    time: int
    rank: int
    process: int
    timer: int
    number: int
    action: Callable[[Any], None]
    argument: Any


class Agenda:
    """The processes, the simulated time `now` in nanoseconds, and the events to come."""

    def __init__(self) -> None:
        self.now = 0
        self.running = True
        self.processes: list[Process] = []
        self.current: Process | None = None  # the process whose code is running, or has failed
        self.service_peers: ServicePeers | None = None  # in real time
        self._events: list[Event] = []
        self._count = 0
        self._starting: Process | None = None

    def stop(self) -> None:
        """Stop running callbacks."""
        self.running = False

    def acknowledged(self, publisher: Publisher, timeout: int | None) -> bool:
        """Return whether what is published has arrived: nothing gets lost on the way."""
        return True

    def assert_liveliness(self, publisher: Publisher) -> None:
        """Do nothing: in simulated time, faults decide what is alive."""

    def add_process(self, name: str, execution_time: int = 0, phase: int = 0) -> Process:
        """Add a process.

        Args:
            name: name in the records.
            execution_time: execution time of each activation, in ns.
            phase: offset of the first firing of its timers, in ns after the start; 0: after their period.

        """
        process = Process(name, len(self.processes), execution_time, phase)
        self.processes.append(process)
        return process

    @contextmanager
    def starting(self, process: Process) -> Iterator[None]:
        """Assign nodes created in this block to the process."""
        self._starting = self.current = process
        yield
        self._starting = self.current = None

    def process_of_new_node(self, name: str) -> Process:
        """Return the process of a new node; a separate one outside a `starting` block."""
        return self._starting or self.add_process(name)

    @property
    def is_within(self) -> bool:
        """Return whether a callback or a constructor is running, so that no time can pass."""
        return self._starting is not None or (self.current is not None and self.current.writes is not None)

    def next_event(self) -> tuple[int, bool] | None:
        """Return the time of the next event, and whether it is a timer; None: there is none."""
        return (self._events[0].time, self._events[0].rank == TIMER) if self._events else None

    def reached(self, time: int) -> int:
        """Return the current time for an event due at this time."""
        return time

    def _schedule(self, time: int, action: Callable[[Any], None], argument: object) -> None:
        self._count += 1
        heappush(self._events, Event(time, SAMPLE, 0, 0, self._count, action, argument))
