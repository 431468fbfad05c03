"""Nodes in real time on the wire: the runtime that `rclpy.init` starts for a single node file.

Callbacks run sequentially in the spinning thread, timers first, subscriptions in turn, as in rclpy's single-threaded
executor. Samples stay in DDS, by their quality of service, until their callback's turn.
"""

from __future__ import annotations

import signal
import struct
import threading
from collections import deque
from collections.abc import Callable, Iterator
from functools import partial
from time import monotonic_ns, sleep, time_ns
from typing import Any, cast

from eventchain_ros2.best_available import for_publisher, for_subscription, is_undecided
from eventchain_ros2.dds_entities import ClosedError, Participant, Reader, WaitSet, Writer
from eventchain_ros2.parameters import Parameter
from eventchain_ros2.qos import QoSProfile, ReliabilityPolicy
from eventchain_ros2.service_peers import Matched
from eventchain_ros2.simulation import End, Process, Publisher, Sample, Simulation, Subscription, Timer
from eventchain_ros2.watch import Watch

CLOCK_TOPIC, CLOCK_TYPE = "/clock", "rosgraph_msgs/msg/Clock"
_CLOCK_QOS = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
_CDR_HEADER = 4
_NANOSECONDS = 1_000_000_000
_FOREVER = 2**62
_LONGEST_SLEEP = 100_000_000
_STEP = 0.01
"""Interval at which a thread looks at what it waits for, in s."""
_LOOK = 1_000_000
"""Interval at which a sleeping thread looks at `/clock`, in ns."""


class Live(Simulation):
    """The nodes of this process; their time is wall time, or that of `/clock` if they use simulated time.

    Args:
        participant: their participant; it is closed with `close`.
        overrides: values of parameters, by the name of a node (`""`: of every node).

    """

    is_simulated = False

    def __init__(self, participant: Participant, overrides: list[tuple[str, Parameter]]) -> None:
        super().__init__()
        self._participant = participant
        self._overrides = overrides
        self._clock: Reader | None = None
        self._shown = 0  # by /clock, in ns
        self._writers: dict[Publisher, Writer] = {}
        self._readers: dict[Subscription, Reader] = {}
        self.service_peers = Matched(self._writers, self._readers)
        self._timers: list[tuple[Timer, int]] = []  # with their tokens
        self._waits: dict[frozenset[Process], _Turns] = {}
        self._errands: deque[tuple[Process, Callable[[], None]]] = deque()
        self.within: set[int] = set()  # the threads that run callbacks
        self._lock = threading.Lock()  # of the errands, which any thread may add
        self._is_announced = True
        self._watch = Watch(participant)
        self._handlers: dict[int, Any] = {}
        self._handle_signals()

    @property
    def now(self) -> int:
        """Return the time in ns: since 1970, or that of `/clock`, initially 0."""
        return time_ns() if self._clock is None else self._shown

    @now.setter
    def now(self, _: int) -> None:
        """Ignore the setting: this clock cannot be set."""

    def overrides(self, node: str) -> list[Parameter]:
        """Return the initial values of a node's parameters."""
        return [parameter for name, parameter in self._overrides if name in ("", node)]

    def follow_clock(self) -> None:
        """Use the time of `/clock` from now on."""
        if self._clock is None:
            self._clock = self._participant.reader(CLOCK_TOPIC, CLOCK_TYPE, _CLOCK_QOS)
            self._changed()

    def add_publisher(self, publisher: Publisher) -> None:
        """Create a writer."""
        publisher.topic.publishers.append(publisher)
        self._decide(publisher, publishes=True)
        profile = publisher.qos_profile
        writer = self._participant.writer(publisher.topic.name, publisher.type_name, profile, _owner(publisher))
        self._writers[publisher] = writer
        matched: Any = _Elsewhere(writer)
        publisher.matched.append(matched)
        self._watch.add(writer)
        self._changed()

    def add_subscription(self, subscription: Subscription) -> None:
        """Create a reader."""
        subscription.topic.subscriptions.append(subscription)
        self._decide(subscription, publishes=False)
        profile = subscription.qos_profile
        owner = _owner(subscription)
        reader = self._participant.reader(subscription.topic.name, subscription.type_name, profile, owner)
        self._readers[subscription] = reader
        self._watch.add(reader)
        self._changed()

    def _decide(self, endpoint: Any, *, publishes: bool) -> None:
        """Decide what is best available by the ends that have been discovered."""
        if is_undecided(endpoint.qos_profile):
            others = self._watch.profiles(Writer if publishes else Reader, endpoint)
            decide = for_publisher if publishes else for_subscription
            endpoint.decide(decide(endpoint.qos_profile, others))

    def remove(self, endpoint: Any) -> None:
        """Close its writer or reader."""
        closed = self._writers.pop(endpoint, None) or self._readers.pop(endpoint, None)
        if closed is not None:
            self._watch.remove(closed)
            closed.close()
            self._is_announced = False

    def publish(self, publisher: Publisher, data: bytes | bytearray | memoryview) -> None:
        """Write a sample.

        Raises:
            ClosedError: the publisher was destroyed.

        """
        if publisher not in self._writers:
            raise ClosedError(f"the publisher on {publisher.topic.name} is destroyed")
        self._writers[publisher].write(data)

    def acknowledged(self, publisher: Publisher, timeout: int | None) -> bool:
        """Return whether all reliable readers have acknowledged everything, within a time in ns."""
        return self._writers[publisher].wait_for_acknowledgments(_FOREVER if timeout is None else timeout)

    def assert_liveliness(self, publisher: Publisher) -> None:
        """Assert the liveliness of a writer."""
        self._writers[publisher].assert_liveliness()

    def add_timer(self, timer: Timer) -> None:
        """Fire the timer when it is due, unless its token has changed by then."""
        self._timers.append((timer, timer.token))
        self._changed()

    def _changed(self) -> None:
        """Notify waiting threads of a new entity."""
        self._is_announced = False
        for turns in list(self._waits.values()):
            turns.wait_set.wake()

    @property
    def is_within(self) -> bool:
        """Return whether this thread is running a callback."""
        return threading.get_ident() in self.within

    def call(self, process: Process, action: Callable[[], None]) -> None:
        """Run a function as a further callback of a process."""
        with self._lock:
            self._errands.append((process, action))
        for turns in list(self._waits.values()):
            turns.wait_set.wake()

    def run_errand(self, processes: frozenset[Process]) -> bool:
        """Run the first function that waits for one of these processes; return whether there was one."""
        with self._lock:
            errand = next((each for each in self._errands if each[0] in processes), None)
            if errand is None:
                return False
            self._errands.remove(errand)
        errand[1]()
        return True

    def errands(self, processes: frozenset[Process]) -> int:
        """Return how many functions wait for these processes."""
        with self._lock:
            return sum(process in processes for process, _ in self._errands)

    def sleep(self, nanoseconds: int) -> bool:
        """Wait in this thread; return whether nodes can run after it. With `/clock`, its time counts."""
        end = (monotonic_ns() if self._clock is None else self._shown) + nanoseconds
        while self.running:
            self._read_clock()
            left = end - (monotonic_ns() if self._clock is None else self._shown)
            if left <= 0:
                break
            sleep(min(left, _LOOK if self._clock else _LONGEST_SLEEP) / _NANOSECONDS)
        return self.running

    def ends(self) -> list[End]:
        """Return the publishers and subscriptions of the domain that have been discovered, by their topics."""
        self._announce()
        return self._watch.ends(self._participant.nodes(own=True))

    def publishers_of(self, subscription: Subscription) -> int:
        """Return the number of matched publishers."""
        reader = self._readers.get(subscription)
        return 0 if reader is None else reader.matched()

    def node_names(self) -> list[tuple[str, str]]:
        """Return the names and namespaces of the nodes that have been discovered, and of those here."""
        self._announce()
        return [(node.name, node.namespace) for node in self._participant.nodes(own=True)]

    def elapsed(self) -> int:
        """Return the time in ns that timeouts count: wall time."""
        return monotonic_ns()

    def wait_until(self, condition: Callable[[], bool], timeout: float | None, expectation: str = "") -> bool:
        """Wait in this thread until a condition holds; return whether it does."""
        self._announce()
        end = None if timeout is None or timeout < 0 else monotonic_ns() + int(timeout * _NANOSECONDS)
        while not condition() and self.running and (end is None or monotonic_ns() < end):
            sleep(_STEP)
        return condition()

    def timers(self, processes: frozenset[Process]) -> list[Timer]:
        """Return the running timers of these processes."""
        self._timers = [(timer, token) for timer, token in self._timers if timer.token == token]
        return [timer for timer, _ in self._timers if timer.process in processes]

    def readers(self, processes: frozenset[Process]) -> list[tuple[Subscription, Reader]]:
        """Return the subscriptions of these processes."""
        return [(each, reader) for each, reader in list(self._readers.items()) if each.process in processes]

    def spin_once(self, processes: set[Process], timeout: int | None) -> bool:
        """Run one callback of these processes, as soon as there is one.

        Args:
            processes: those whose callbacks may run.
            timeout: the longest time to wait, in ns of wall time; None: no limit.

        Returns:
            Whether a callback ran: false if the time was over, or nodes were shut down.

        """
        group = frozenset(processes)
        turns = self._waits.get(group)
        if turns is None:
            turns = self._waits[group] = _Turns(self, group, WaitSet(self._participant))
        end = None if timeout is None else monotonic_ns() + timeout
        while self.running:
            self._read_clock()
            self._announce()
            if turns.take():
                return True
            left = None if end is None else end - monotonic_ns()
            if left is not None and left <= 0:
                return False
            turns.wait(left, self._clock)
        return False

    def _read_clock(self) -> None:
        samples = self._clock.take() if self._clock else []
        if samples:
            data = samples[-1].data
            seconds, nanoseconds = struct.unpack_from("<iI" if data[1] & 1 else ">iI", data, _CDR_HEADER)
            before, self._shown = self._shown, seconds * _NANOSECONDS + nanoseconds
            if self._shown < before:
                self._restart_timers()

    def _restart_timers(self) -> None:
        """Restart the period of timers whose last call is in the future, after the clock went back (rcl_timer)."""
        for timer, token in list(self._timers):
            period = cast(Any, timer).timer_period_ns
            if timer.token == token and timer.due - period > self._shown:
                timer.due = self._shown + period

    def _announce(self) -> None:
        if self._is_announced:
            return
        self._is_announced = True
        for process in self.processes:
            writers = [writer for each, writer in self._writers.items() if each.process is process]
            readers = [reader for each, reader in self._readers.items() if each.process is process]
            self._participant.announce(process.name, process.namespace, writers, readers)

    def _handle_signals(self) -> None:
        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGINT, signal.SIGTERM):
                self._handlers[number] = signal.signal(number, self._interrupt)

    def _interrupt(self, number: int, _: object) -> None:
        self.stop()
        if number == signal.SIGINT:
            raise KeyboardInterrupt

    def stop(self) -> None:
        """Stop running callbacks; spinning threads return."""
        self.running = False
        if threading.current_thread() is threading.main_thread():
            for number, handler in self._handlers.items():
                signal.signal(number, handler)
            self._handlers.clear()
        for turns in list(self._waits.values()):
            turns.wait_set.wake()

    def close(self) -> None:
        """Close the participant."""
        self.running = False
        self._participant.close()


def _owner(endpoint: Any) -> str:
    owner: str = endpoint.owner
    return owner


class _Elsewhere:
    """Placeholder for the remote subscriptions matched by a writer."""

    def __init__(self, writer: Writer) -> None:
        self._writer = writer

    @property
    def count(self) -> int:
        return self._writer.matched()


class _Turns:
    """Scheduling of an executor's timers and subscriptions."""

    def __init__(self, live: Live, processes: frozenset[Process], wait_set: WaitSet) -> None:
        self.wait_set = wait_set
        self._live = live
        self._processes = processes
        self._attached: set[Reader] = set()
        self._queue: deque[Callable[[], bool]] = deque()

    def take(self) -> bool:
        """Run the next callback; return whether there was one. After its turn, each waits for all others."""
        if self._take():
            return True
        self._queue.extend(self._everybody())
        return self._take()

    def _take(self) -> bool:
        thread, within = threading.get_ident(), self._live.within
        is_outermost = thread not in within
        within.add(thread)
        try:
            while self._queue and self._live.running:
                if self._queue.popleft()():
                    return True
        finally:
            if is_outermost:
                within.remove(thread)
        return False

    def _everybody(self) -> Iterator[Callable[[], bool]]:
        now = self._live.now
        for timer in self._live.timers(self._processes):
            if timer.due <= now:
                yield partial(self._fire, timer, timer.token)
        for _ in range(self._live.errands(self._processes)):
            yield partial(self._live.run_errand, self._processes)
        for subscription, reader in self._live.readers(self._processes):
            yield partial(self._receive, subscription, reader)

    def _fire(self, timer: Timer, token: int) -> bool:
        now = self._live.now
        if timer.token != token or timer.due > now:
            return False
        timer.advance(now)
        timer.run(None)
        return True

    def _receive(self, subscription: Subscription, reader: Reader) -> bool:
        try:
            samples = reader.take(1)
        except ClosedError:
            return False  # destroyed meanwhile
        for sample in samples:
            topic, time = subscription.topic.name, sample.source_timestamp
            subscription.receive(Sample(topic, 0, time, sample.data, sample.publication))
        return bool(samples)

    def wait(self, timeout: int | None, clock: Reader | None) -> None:
        """Wait until a callback may be ready, at most for this time, in ns."""
        wanted = {reader for _, reader in self._live.readers(self._processes)} | ({clock} if clock else set())
        for reader in wanted - self._attached:
            self.wait_set.attach(reader)
        self._attached = wanted
        if clock is None:  # else /clock determines when timers are due
            now = self._live.now
            due = [timer.due - now for timer in self._live.timers(self._processes)]
            timeout = min([*due, *([] if timeout is None else [timeout])], default=None)
        self.wait_set.wait(timeout if timeout is None else max(timeout, 0))
