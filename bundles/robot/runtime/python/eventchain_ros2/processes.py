"""Processes, topics and samples, and a simulation's view of publishers, subscriptions and timers."""

from __future__ import annotations

import struct
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol
from zlib import crc32

from eventchain_ros2.faults import NEVER
from eventchain_ros2.parameters import Parameter
from eventchain_ros2.qos import HistoryPolicy, QoSProfile

WORLD = "world"
"""The name of the node whose publishers and subscriptions are those of the simulated world."""


class LimitError(BaseException):
    """A scenario exceeded its number of publications or activations. Not an `Exception`, so that nodes end."""


class LateEndpointError(BaseException):
    """A publisher or subscription is created or destroyed too late. Not an `Exception`, so that nodes end."""

    hint = "Make all publishers and subscriptions in the node's constructor, and keep them."


class Sample(NamedTuple):
    """A message on the wire; `time` is when it becomes visible, `sequence` counts the publications on the topic.

    `writer` is the handle of its writer on DDS, where there is one.
    """

    topic: str
    sequence: int
    time: int
    data: bytes | bytearray | memoryview
    writer: int = 0


class Activation(NamedTuple):
    """One run of a callback: simulated start and end, all in ns, and `(topic, sequence)` of samples.

    `host` is the used processor time. `reads` has the last sample received on each subscribed topic of the process.
    """

    start: int
    end: int
    host: int
    reads: list[tuple[str, int]]
    writes: list[tuple[str, int]]


class Warned(NamedTuple):
    """A connection that was not made: no samples are exchanged."""

    id: str
    topic: str
    message: str


class Publisher(Protocol):
    """A simulation's view of a publisher: `matched` ones get its samples, late subscriptions those `retained`."""

    process: Process
    topic: Topic
    type_name: str
    qos_profile: QoSProfile
    matched: list[Subscription]
    retained: deque[Sample]

    def decodes(self, data: bytes | bytearray | memoryview) -> bool:
        """Return whether these bytes are a message of its type: DDS delivers only those."""


class Subscription(Protocol):
    """A simulation's view of a subscription."""

    process: Process
    topic: Topic
    type_name: str
    qos_profile: QoSProfile

    def receive(self, sample: Sample) -> None:
        """Run the callback."""


class ServicePeers(Protocol):
    """Clients and servers outside of a simulation, for its own servers and clients."""

    def is_served(self, requests: Publisher, replies: Subscription) -> bool:
        """Return whether a server takes these requests and gives these replies."""

    def wait_for_client(self, requests: Subscription, replies: Publisher, writer: int) -> None:
        """Wait until the client whose requests come from a writer receives the replies, for a short time at most."""


class Timer(Protocol):
    """A simulation's view of a timer: it fires when it is `due`, unless its `token` has changed by then."""

    process: Process
    index: int
    due: int
    token: int

    def advance(self, now: int) -> None:
        """Advance to the next period that has not passed."""

    def run(self, _: None) -> None:
        """Run the callback."""


class Bridge(Protocol):
    """Connects a simulation with its outside: it is notified of new publishers and subscriptions."""

    def opened(self, endpoint: Publisher | Subscription) -> None:
        """Handle a new endpoint."""

    def closed(self, endpoint: Publisher | Subscription) -> None:
        """Handle a destroyed endpoint."""

    def publishers_of(self, subscription: Subscription) -> int:
        """Return the number of outside publishers whose samples a subscription receives."""


class End(NamedTuple):
    """A publisher or subscription as queries of the graph show it, with the name of its node."""

    topic: str
    type_name: str
    publishes: bool
    node: str
    namespace: str
    qos_profile: QoSProfile
    gid: bytes


class Topic:
    """The publishers and subscriptions of a topic, and the `(sequence, time)` of everything published."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.publications: list[tuple[int, int]] = []
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []

    def ends(self) -> Iterator[End]:
        """Return its publishers and subscriptions."""
        for number, publisher in enumerate(self.publishers):
            yield self._end(publisher, number, publishes=True)
        for number, subscription in enumerate(self.subscriptions):
            yield self._end(subscription, number, publishes=False)

    def _end(self, each: Publisher | Subscription, number: int, *, publishes: bool) -> End:
        owner = each.process
        gid = struct.pack("<IIII", crc32(self.name.encode()), publishes, owner.index, number)
        return End(self.name, each.type_name, publishes, owner.name or WORLD, owner.namespace, each.qos_profile, gid)


class Launched(NamedTuple):
    """Settings that a launch file gives a node, as arguments of the command line would.

    Args:
        name: its name; empty for its own.
        namespace: its namespace; empty for its own.
        remappings: full names of topics by the names that the node uses.
        arguments: what it is made with, by the names of parameters; None for what the file of its class says.
        parameters: values of its parameters of ROS 2, by their names.

    """

    name: str = ""
    namespace: str = ""
    remappings: Mapping[str, str] = MappingProxyType({})
    arguments: Mapping[str, Any] | None = None
    parameters: Mapping[str, Any] = MappingProxyType({})

    def overrides(self) -> list[Parameter]:
        """Return the parameters.

        Raises:
            TypeError: no parameter can have such a value.

        """
        return [Parameter(name, value=value) for name, value in self.parameters.items()]


class Process:
    """A process that runs the callbacks of its nodes sequentially."""

    def __init__(self, name: str, index: int, execution_time: int, phase: int) -> None:
        self.name = name
        self.index = index
        self.execution_time = execution_time
        self.phase = phase
        self.namespace = "/"  # of its node
        self.launched = Launched()
        self.timers = 0
        self.busy_until = 0
        self.paused = False  # while an executor of other nodes runs
        self.inbox: list[tuple[Subscription, Sample]] = []
        self.latest: dict[str, int] = {}
        # The sample that the running callback is given, and the one of its topic that was read before.
        self.held: tuple[Sample, int | None] | None = None
        self.writes: list[tuple[str, int]] | None = None  # of the running callback
        self.activations: list[Activation] = []

    def keep(self, subscription: Subscription, sample: Sample) -> None:
        """Keep a sample for later, dropping the oldest one beyond the subscription's history."""
        self.inbox.append((subscription, sample))
        capacity = subscription.qos_profile.capacity()
        mine = [index for index, (receiver, _) in enumerate(self.inbox) if receiver is subscription]
        if capacity is not None and len(mine) > capacity:
            del self.inbox[mine[0]]

    def read(self, sample: Sample) -> None:
        """Count a sample as read by the callbacks from now on."""
        self.held = sample, self.latest.get(sample.topic)
        self.latest[sample.topic] = sample.sequence

    def hold(self) -> Sample | None:
        """Return the sample of the running callback, which does not count as read until it is given on."""
        if self.held is None:
            return None
        sample, before = self.held
        if before is None:
            self.latest.pop(sample.topic, None)
        else:
            self.latest[sample.topic] = before
        return sample

    def end(self) -> None:
        """Stop running callbacks; waiting samples are never received."""
        self.busy_until = NEVER
        self.writes = None
        self.inbox.clear()


class Errand:
    """A function that a process runs as a callback: a subscription with one sample, `NOTHING`."""

    qos_profile = QoSProfile(history=HistoryPolicy.KEEP_ALL)

    def __init__(self, process: Process, action: Callable[[], None]) -> None:
        self.process = process
        self._action = action

    def receive(self, _: Sample) -> None:
        """Run the function."""
        self._action()


NOTHING = Sample("", -1, 0, b"")
"""The sample of an errand."""
