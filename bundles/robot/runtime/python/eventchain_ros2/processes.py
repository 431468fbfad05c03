"""Processes and topics, what flows between them, and what a simulation knows of publishers, subscriptions, timers."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple, Protocol

from eventchain_ros2.faults import NEVER
from eventchain_ros2.qos import QoSProfile


class LateEndpointError(BaseException):
    """A publisher or subscription comes or goes when it no longer may. Not an `Exception`: nodes shall not go on."""

    hint = "Make all publishers and subscriptions in the node's constructor, and keep them."


class Sample(NamedTuple):
    """A message on the wire; `time` is when it can be seen, `sequence` counts the publications on the topic."""

    topic: str
    sequence: int
    time: int
    data: bytes | bytearray | memoryview


class Activation(NamedTuple):
    """One run of a callback: simulated start and end, all in ns, and `(topic, sequence)` of samples.

    `host` is the processor time that was spent. `reads` has the last sample received on each topic that the process
    subscribes to.
    """

    start: int
    end: int
    host: int
    reads: list[tuple[str, int]]
    writes: list[tuple[str, int]]


class Warned(NamedTuple):
    """A connection that was not made: no sample flows."""

    id: str
    topic: str
    message: str


class Publisher(Protocol):
    """What the simulation knows of a publisher: who is `matched` gets its samples, who joins later those `retained`."""

    process: Process
    topic: Topic
    type_name: str
    qos_profile: QoSProfile
    matched: list[Subscription]
    retained: deque[Sample]

    def decodes(self, data: bytes | bytearray | memoryview) -> bool:
        """Whether these bytes are a message of its type: DDS hands on nothing else."""


class Subscription(Protocol):
    """What the simulation knows of a subscription."""

    process: Process
    topic: Topic
    type_name: str
    qos_profile: QoSProfile

    def receive(self, sample: Sample) -> None:
        """Call back."""


class Timer(Protocol):
    """What the simulation knows of a timer: it fires when it is `due`, unless its `token` has changed by then."""

    process: Process
    index: int
    due: int
    token: int

    def advance(self, now: int) -> None:
        """Move on to the next period that has not passed."""

    def run(self, _: None) -> None:
        """Call back."""


class Bridge(Protocol):
    """Connects a simulation with what is outside it: it is told of publishers and subscriptions as they are made."""

    def opened(self, endpoint: Publisher | Subscription) -> None:
        """One was made."""

    def closed(self, endpoint: Publisher | Subscription) -> None:
        """One is used no more."""


class Topic:
    """The publishers and subscriptions of a topic, and the `(sequence, time)` of everything published."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.publications: list[tuple[int, int]] = []
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []


class Process:
    """A process that runs the callbacks of its nodes one after the other."""

    def __init__(self, name: str, index: int, execution_time: int, phase: int) -> None:
        self.name = name
        self.index = index
        self.execution_time = execution_time
        self.phase = phase
        self.namespace = "/"  # of its node
        self.timers = 0
        self.busy_until = 0
        self.paused = False  # while an executor runs that has other nodes
        self.inbox: list[tuple[Subscription, Sample]] = []
        self.latest: dict[str, int] = {}
        self.writes: list[tuple[str, int]] | None = None  # of the callback that runs
        self.activations: list[Activation] = []

    def keep(self, subscription: Subscription, sample: Sample) -> None:
        """Keep a sample for later, dropping the oldest one beyond the subscription's history."""
        self.inbox.append((subscription, sample))
        capacity = subscription.qos_profile.capacity()
        mine = [index for index, (receiver, _) in enumerate(self.inbox) if receiver is subscription]
        if capacity is not None and len(mine) > capacity:
            del self.inbox[mine[0]]

    def end(self) -> None:
        """Run no callback any more; what waits is never received."""
        self.busy_until = NEVER
        self.writes = None
        self.inbox.clear()
