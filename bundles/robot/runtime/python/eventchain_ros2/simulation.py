"""The ROS graph in simulated time: topics, processes with one single-threaded executor each, and the order of events.

An activation (a timer's callback, or a subscription's that publishes) starts at t and takes the execution time E of its
process: it reads the samples received until t, its publications are visible from t + E on, and the process is busy
until then. At one instant, samples come before timers, and timers in the order of their processes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from heapq import heappop, heappush
from time import thread_time_ns
from typing import Any

from eventchain_ros2.agenda import SAMPLE, TIMER, WAITS, Agenda, Event
from eventchain_ros2.best_available import Undecided, is_undecided
from eventchain_ros2.faults import NEVER, Fault
from eventchain_ros2.processes import (
    NOTHING,
    WORLD,
    Activation,
    Bridge,
    End,
    Errand,
    LimitError,
    Process,
    Publisher,
    Sample,
    Subscription,
    Timer,
    Topic,
    Warned,
)
from eventchain_ros2.qos import DurabilityPolicy, incompatible_policies

__all__ = [
    "Activation",
    "Bridge",
    "End",
    "LimitError",
    "Process",
    "Publisher",
    "Sample",
    "Simulation",
    "Subscription",
    "Timer",
    "Topic",
    "Warned",
]

MOST_RECORDS = 250_000
"""Publications and activations of one scenario together; a minute of 20 nodes at 100 Hz has about that."""


class Simulation(Agenda):
    """All processes and topics, and the simulated time `now` in nanoseconds."""

    is_simulated = True

    def __init__(self) -> None:
        super().__init__()
        self.bridge: Bridge | None = None
        self.topics: dict[str, Topic] = {}
        self.warnings: list[Warned] = []
        self._undecided = Undecided()
        self._records = 0
        self._spent = 0  # processor time of components within the running callback, ns
        self._sent = False  # whether the running callback has published
        self._expected: list[tuple[Process, Callable[[], bool], str]] = []
        self.clients = 0  # of services, made so far
        self.fault: Fault | None = None
        self.survives: Callable[[Process, BaseException], bool] | None = None

    def _record(self) -> None:
        self._records += 1
        if self._records > MOST_RECORDS:
            raise LimitError(f"the nodes publish and execute more than {MOST_RECORDS:,} times in one scenario")

    def overrides(self, node: str) -> list[Any]:
        """Return the initial values of a node's parameters: none, since its creator sets them."""
        return []

    def follow_clock(self) -> None:
        """Show the time of `/clock`: the same as the simulated time."""

    def clock(self, process: Process) -> int:
        """Return the time on the clock of a process, in ns."""
        return self.now if self.fault is None else self.fault.clock(process.name, self.now)

    def clock_of_callback(self) -> int:
        """Return the time on the clock of the process whose callback is running, in ns; else the simulated time."""
        return self.now if self.current is None else self.clock(self.current)

    def spend(self, nanoseconds: int) -> None:
        """Add processor time used elsewhere for the running callback."""
        self._spent += nanoseconds

    def first_firing(self, process: Process, period: int) -> int:
        """Return the first firing of a new timer."""
        return self.now + (process.phase if process is self._starting and process.phase else period)

    def topic(self, name: str) -> Topic:
        """Return the topic of this name."""
        if name not in self.topics:
            self.topics[name] = Topic(name)
        return self.topics[name]

    def add_publisher(self, publisher: Publisher) -> None:
        """Connect a publisher with the subscriptions of its topic."""
        self._undecided.add(publisher, publishes=True, bridged=self.bridge is not None)
        publisher.topic.publishers.append(publisher)
        for subscription in publisher.topic.subscriptions:
            self._connect(publisher, subscription)
        if self.bridge:
            self.bridge.opened(publisher)

    def add_subscription(self, subscription: Subscription) -> None:
        """Connect a subscription with the publishers of its topic."""
        self._undecided.add(subscription, publishes=False, bridged=self.bridge is not None)
        subscription.topic.subscriptions.append(subscription)
        for publisher in subscription.topic.publishers:
            self._connect(publisher, subscription)
        if self.bridge:
            self.bridge.opened(subscription)

    def settle(self) -> None:
        """Decide what is best available, once all nodes have started and before any time passes."""
        for publisher, subscription in self._undecided.settle():
            self._connect(publisher, subscription)
        while self._expected:
            self.current, condition, what = self._expected.pop()
            if not condition():
                raise RuntimeError(f"{what}, but none of the nodes has started it")

    def remove(self, endpoint: Publisher | Subscription) -> None:
        """Notify the bridge of a destroyed endpoint."""
        if self.bridge:
            self.bridge.closed(endpoint)

    def ends(self) -> list[End]:
        """Return all publishers and subscriptions, by their topics."""
        if self.bridge:
            raise NotImplementedError("queries of the graph are not answered on DDS between the nodes of a chain")
        return [end for _, topic in sorted(self.topics.items()) for end in topic.ends()]

    def publishers_of(self, subscription: Subscription) -> int:
        """Return the number of publishers whose samples a subscription receives."""
        outside = self.bridge.publishers_of(subscription) if self.bridge else 0
        return outside + sum(subscription in publisher.matched for publisher in subscription.topic.publishers)

    def node_names(self) -> list[tuple[str, str]]:
        """Return the names and namespaces of all nodes."""
        return [(process.name or WORLD, process.namespace) for process in self.processes]

    def _connect(self, publisher: Publisher, subscription: Subscription) -> None:
        if is_undecided(publisher.qos_profile) or is_undecided(subscription.qos_profile):
            return  # until it is decided
        topic = publisher.topic.name
        if publisher.type_name != subscription.type_name:
            types = f"{subscription.type_name} is subscribed and {publisher.type_name} published"
            self._warn("topic.type.mismatch", topic, f"On topic '{topic}', {types}. No messages will be received.")
            return
        policies = ", ".join(incompatible_policies(publisher.qos_profile, subscription.qos_profile))
        if policies:
            text = f"New publisher discovered on topic '{topic}', offering incompatible QoS."
            text += f" No messages will be received from it. Last incompatible policy: {policies}"
            self._warn("qos.incompatible", topic, text)
            return
        publisher.matched.append(subscription)
        if subscription.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL:
            for sample in publisher.retained:
                self._schedule(self.now, self._hand_over, (subscription, sample))

    def _warn(self, identifier: str, topic: str, message: str) -> None:
        self.warnings.append(Warned(identifier, topic, message))
        print(f"[WARN] {message}", file=sys.stderr)

    def publish(self, publisher: Publisher, data: bytes | bytearray | memoryview) -> None:
        """Send a sample; it is visible when the publishing activation has ended."""
        process, time = publisher.process, self.now
        if process.writes is not None:
            self._sent = True
            time = self.ended(process)
        if self.fault is None:
            self._send(publisher, time, data)
        elif time < NEVER:
            topic = publisher.topic.name
            for each in self.fault.sent(process.name, topic, time, data):
                if each is data or publisher.decodes(each):
                    self._send(publisher, self.fault.visible(process.name, topic, time), each)

    def _send(self, publisher: Publisher, time: int, data: bytes | bytearray | memoryview) -> None:
        topic, process = publisher.topic, publisher.process
        sequence = len(topic.publications)
        if process.writes is not None:
            process.writes.append((topic.name, sequence))
        self._record()
        topic.publications.append((sequence, time))
        self._schedule(time, self._deliver, (publisher, Sample(topic.name, sequence, time, data)))

    def add_timer(self, timer: Timer) -> None:
        """Fire the timer at its `due` time, unless its `token` has changed by then."""
        process = timer.process
        self._count += 1
        time = self._free(process, timer.due)
        if time >= NEVER:
            return
        fire = (self._fire, (timer, timer.token))
        heappush(self._events, Event(time, TIMER, process.index, timer.index, self._count, *fire))

    def advance(self, until: int) -> None:
        """Let time pass. Events due exactly at `until` belong to the next call, after the samples published then."""
        self.settle()
        events = self._events
        while events and events[0].time < until and self.running:
            event = heappop(events)
            self.now = event.time
            event.action(event.argument)
        self.now, self.current = until, None

    def happen(self, until: int, *, timers: bool) -> None:
        """Run all events that are due until then, inclusive; timers of that time only on request."""
        self.settle()
        last = until, (TIMER if timers else SAMPLE)
        events = self._events
        while events and events[0][:2] <= last and self.running:
            event = heappop(events)
            self.now = self.reached(event.time)
            event.action(event.argument)
        self.now, self.current = self.reached(until), None

    def ended(self, process: Process) -> int:
        """Return the time at which the running callback ends."""
        end = self.now + process.execution_time
        return end if self.fault is None else self.fault.ended(process.name, self.now, end)

    def call(self, process: Process, action: Callable[[], None]) -> None:
        """Run a function as a further callback of a process, as soon as it is free."""
        self._schedule(self.now, self._hand_over, (Errand(process, action), NOTHING))

    def sleep(self, nanoseconds: int) -> bool:
        """Let time pass, without any callback; return whether nodes can run after it."""
        if nanoseconds > 0:
            self.spin_once(set(), nanoseconds)
        return self.running

    def elapsed(self) -> int:
        """Return the time in ns that timeouts count."""
        return self.now

    def wait_until(self, condition: Callable[[], bool], timeout: float | None, expectation: str = "") -> bool:
        """Let time pass, without any callback, until a condition holds; return whether it does.

        Args:
            condition: what to wait for.
            timeout: the longest time, in s; None: no limit.
            expectation: what is expected, in words, if a constructor may go on as if it were so, since all nodes
                start at once. If it does not hold when they have started, that is an error.

        """
        if condition():
            return True
        if self._starting is not None and expectation:
            self._expected.append((self._starting, condition, expectation))
            return True
        if self.is_within and timeout != 0:
            raise RuntimeError(WAITS)
        if timeout is None or timeout < 0:
            raise RuntimeError("nothing will ever happen: what is waited for is not there, and no callback runs")
        self.sleep(int(timeout * 1e9))
        return condition()

    def _free(self, process: Process, time: int) -> int:
        """Return the earliest time, not before this one, at which a process may run a callback."""
        time = process.busy_until if process.busy_until > time else time  # faster than max()
        return time if self.fault is None else self.fault.free(process.name, time)

    def spin_once(self, processes: set[Process], timeout: int | None) -> bool:
        """Let time pass until a callback of one of these processes has run, without those of others.

        Samples for the others wait, within their history depths, and so do their timers.

        Args:
            processes: those whose callbacks may run.
            timeout: the longest time to pass, in ns, inclusive. None: no limit.

        Returns:
            Whether a callback ran.

        Raises:
            RuntimeError: there is no limit, and no further event; or a callback wants to wait.

        """
        if self.is_within:
            raise RuntimeError(WAITS)
        self.settle()
        limit = None if timeout is None else self.now + timeout
        for process in self.processes:
            process.paused = process not in processes
            if process.inbox and not process.paused:
                self._schedule(max(self.now, process.busy_until), self._wake, process)
        late: list[Event] = []
        try:
            return self._run_until_callback(limit, late)
        finally:
            for process in self.processes:
                process.paused = False
            for event in late:
                heappush(self._events, event)

    def _run_until_callback(self, limit: int | None, late: list[Event]) -> bool:
        """Run events up to the limit or the first callback; timers of paused processes become late."""
        events = self._events
        while self.running and events and (limit is None or events[0].time <= limit):
            event = heappop(events)
            if event.rank == TIMER and self.processes[event.process].paused:
                late.append(event)
                continue
            self.now, self.current = max(self.now, event.time), None
            event.action(event.argument)
            if self.current is not None:
                return True
        if limit is None and self.running:
            raise RuntimeError("nothing will ever happen: there is neither a sample nor a timer to wait for")
        self.now = self.now if limit is None else max(self.now, limit)
        return False

    def _deliver(self, published: tuple[Publisher, Sample]) -> None:
        publisher, sample = published
        publisher.retained.append(sample)
        for subscription in publisher.matched:
            self._hand_over((subscription, sample))

    def _hand_over(self, received: tuple[Subscription, Sample]) -> None:
        subscription, sample = received
        process = subscription.process
        if process.inbox or process.paused:
            process.keep(subscription, sample)
            return
        free = self._free(process, self.now)
        if free == self.now:
            self._receive(process, subscription, sample)
        elif free < NEVER:
            process.keep(subscription, sample)
            self._schedule(free, self._wake, process)

    def _wake(self, process: Process) -> None:
        while process.inbox and self._free(process, self.now) == self.now and not process.paused:
            subscription, sample = process.inbox.pop(0)
            self._receive(process, subscription, sample)
        if process.inbox and not process.paused:
            free = self._free(process, self.now)
            if free >= NEVER:
                process.inbox.clear()
            else:
                self._schedule(free, self._wake, process)

    def _receive(self, process: Process, subscription: Subscription, sample: Sample) -> None:
        if sample is not NOTHING:
            process.read(sample)
        self._activate(process, subscription.receive, sample, timed=False)
        process.held = None

    def _fire(self, scheduled: tuple[Timer, int]) -> None:
        timer, token = scheduled
        if timer.token != token:
            return
        process = timer.process
        if self._free(process, self.now) == self.now:
            timer.advance(self.now)
            self._activate(process, timer.run, None, timed=True)
            if timer.token != token:  # cancelled or reset by its own callback
                return
        self.add_timer(timer)

    def _activate(self, process: Process, callback: Callable[[Any], None], argument: Any, *, timed: bool) -> None:
        """Run a callback; that of a timer always takes its execution time, others only if they publish."""
        self.current = process
        writes: list[tuple[str, int]] = []
        process.writes = writes
        self._spent, self._sent = 0, False
        started = thread_time_ns() if process.name else 0  # the world takes no time
        try:
            callback(argument)
        except BaseException as error:
            process.writes = None
            if self.survives is None or not self.survives(process, error):
                raise
            process.end()
            return
        process.writes = None
        if not timed and not self._sent:
            return
        host = thread_time_ns() - started + self._spent
        process.busy_until = self.ended(process)
        if process.busy_until < NEVER:
            reads = list(process.latest.items())
            self._record()
            process.activations.append(Activation(self.now, process.busy_until, host, reads, writes))
