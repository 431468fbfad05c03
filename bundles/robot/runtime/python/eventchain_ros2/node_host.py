"""Host of one node on DDS: simulated time is set from outside, samples are exchanged on the wire.

The protocol is described in this bundle's README. At one instant samples are written and received first (PUBLISH), and
when all of them have arrived everywhere timers fire (RUN), so that the order is that of lock-step.
"""

from __future__ import annotations

import select
import signal
import struct
import sys
import time
from typing import Any

from eventchain_ros2.channel import Channel, Kind
from eventchain_ros2.dds_entities import Participant, Reader, Writer
from eventchain_ros2.failures import HostError
from eventchain_ros2.hosting import Host, HostedNodes, parse, unexpected
from eventchain_ros2.node_sources import NodeSources
from eventchain_ros2.preparation import prepared
from eventchain_ros2.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from eventchain_ros2.real_time import RealTime
from eventchain_ros2.wire import Doorbell, Wire

CLOCK_TOPIC = "/clock"
CLOCK_TYPE = "rosgraph_msgs/msg/Clock"

_TIME = struct.Struct("<q")
_CLOCK = struct.Struct("<iI")
_CDR_HEADER = 4
_LOOK_SECONDS = 0.05
_NANOSECONDS = 1_000_000_000


class NodeOnWire(HostedNodes):
    """The node of one configuration and its connections."""

    def __init__(self, configuration: dict[str, Any], participant: Participant, doorbell: Doorbell) -> None:
        super().__init__(configuration, RealTime() if configuration.get("real_time") else None)
        self._participant = participant
        self.wire = Wire(participant, doorbell, self.simulation)
        self._is_connected = False

    @property
    def real_time(self) -> RealTime | None:
        """Return the simulation if it runs in wall time."""
        return self.simulation if isinstance(self.simulation, RealTime) else None

    def start(self, sources: NodeSources) -> None:
        """Create the node, and announce it in the ROS graph."""
        self.prepare(sources)
        self.start_nodes()
        for process in self.processes:
            writers = [outlet.writer for outlet in self.wire.outlets]
            readers = [inlet.reader for inlet in self.wire.inlets]
            self._participant.announce(process.name, "/", writers, readers)

    def ready(self) -> dict[str, Any]:
        """Return the content of the READY frame."""
        self.wire.seal()
        return {
            "writers": [_described(outlet, outlet.writer) for outlet in self.wire.outlets],
            "readers": [_described(inlet, inlet.reader) for inlet in self.wire.inlets],
            "warnings": self.warnings(),
        }

    def connect(self, wanted: dict[str, Any]) -> dict[str, Any]:
        """Wait until each endpoint has matched those that it is to find; return the content of the CONNECTED frame.

        Those are named by their GUIDs, since those of the previous scenario are known for a while.
        """
        self.wire.take_turns(wanted["turns"])
        ends = [
            *(
                ("writer", end.topic.name, end.writer, frozenset(peers))
                for end, peers in self._paired(self.wire.outlets, wanted["writers"])
            ),
            *(
                ("reader", end.topic.name, end.reader, frozenset(peers))
                for end, peers in self._paired(self.wire.inlets, wanted["readers"])
            ),
        ]
        until = time.monotonic() + wanted["timeout_s"]
        while (missing := _missing(ends)) and time.monotonic() < until:
            time.sleep(0.002)
        self._is_connected = True
        return {"missing": missing}

    def _paired(self, ends: list[Any], peers: list[list[str]]) -> list[tuple[Any, list[str]]]:
        if len(ends) != len(peers):
            raise HostError("protocol.frame", f"a CONNECT frame for {len(peers)} ends instead of {len(ends)}")
        return list(zip(ends, peers, strict=True))

    def idle(self, answered: int) -> dict[str, Any]:
        """Return the content of the IDLE frame."""
        return {
            "answered": answered,
            "next": self.simulation.next_event(),
            "samples": self.wire.has_samples,
            "wrote": [outlet.written for outlet in self.wire.outlets],
            "read": [inlet.received for inlet in self.wire.inlets],
        }

    def finished(self) -> dict[str, Any]:
        """Return the content of the FINISHED frame: samples are identified by their source timestamps."""
        nodes = self.activations()
        for node in nodes:
            node["activations"] = [
                activation._replace(
                    reads=self.wire.stamped(activation.reads), writes=self.wire.stamped(activation.writes)
                )
                for activation in node["activations"]
            ]
        return {
            "nodes": nodes,
            "publications": self.wire.publications(),
            "events": self.wire.events(),
            "late": self.real_time.late if self.real_time else 0,
        }

    def end(self) -> None:
        """End the component, and close all entities except the participant."""
        self.wire.close()
        super().end()


def _missing(ends: list[tuple[str, str, Writer | Reader, frozenset[str]]]) -> list[list[Any]]:
    """Return the ends that have not matched all of their peers: kind, topic, and how many of how many they have."""
    missing = []
    for kind, topic, end, guids in ends:
        found = len(guids & {peer.guid.hex() for peer in end.peers()}) if guids else 0
        if found < len(guids):
            missing.append([kind, topic, found, len(guids)])
    return missing


def _described(end: Any, endpoint: Writer | Reader) -> dict[str, Any]:
    profile = end.qos_profile
    return {
        "guid": endpoint.guid.hex(),
        "topic": end.topic.name,
        "type": end.type_name,
        "best_effort": profile.reliability == ReliabilityPolicy.BEST_EFFORT,
        "transient": profile.durability == DurabilityPolicy.TRANSIENT_LOCAL,
        "manual": profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC,
        "deadline": profile.deadline.nanoseconds,
        "lease": profile.liveliness_lease_duration.nanoseconds,
    }


class NodeHost(Host):
    """Advances the time of a node as requested, and reports when it is idle."""

    def __init__(self, channel: Channel, participant: Participant, doorbell: Doorbell) -> None:
        super().__init__(channel)
        self._participant = participant
        self._doorbell = doorbell
        self._clock: Reader | None = None
        self._shown = -1  # time of /clock, in ns
        self._answered = 0
        self._node: NodeOnWire | None = None

    @property
    def nodes(self) -> HostedNodes | None:
        """Return the node."""
        return self._node

    def next_frame(self) -> tuple[int, memoryview] | None:
        """Wait for a frame, and meanwhile report arriving samples."""
        sources = [self.channel.fileno(), self._doorbell.fileno()]
        while True:
            readable, _, _ = select.select(sources, [], [], self._wait())
            if sources[0] in readable:
                return self.channel.read()
            if readable:
                self._answer_doorbell()
            self._keep_up()

    def _wait(self) -> float | None:
        """Return the time until the next action, in s; None: until something arrives."""
        node = self._node
        return node.real_time.wait(has_samples=node.wire.has_samples) if node is not None and node.real_time else None

    def _keep_up(self) -> None:
        """In real time, run everything that is due."""
        node = self._node
        if node is None or node.real_time is None or not node.real_time.is_running:
            return
        self.limit()
        if node.wire.has_samples:
            node.simulation.now = node.real_time.elapsed()
            node.wire.deliver()
        node.simulation.happen(node.real_time.elapsed(), timers=True)
        signal.setitimer(signal.ITIMER_PROF, 0)

    def _answer_doorbell(self) -> None:
        self._read_clock()
        collected = self._node is not None and self._node.wire.collect()
        self._doorbell.answer()
        if collected and self._node is not None and self._waits_for_others:
            self._tell()

    @property
    def _waits_for_others(self) -> bool:
        """Return whether arriving samples have to be reported, since time waits for them."""
        assert self._node is not None
        return self._node.real_time is None or self._node.real_time.is_over

    def _tell(self) -> None:
        if self._node is not None:
            self.channel.write_json(Kind.IDLE, self._node.idle(self._answered))

    def answer(self, kind: int, payload: memoryview) -> None:
        """Answer a frame."""
        if kind in (Kind.CONFIGURE, Kind.RESET):
            self._configure(parse(payload))
        elif self._node is None:
            raise unexpected(kind)
        elif kind == Kind.CONNECT:
            self.channel.write_json(Kind.CONNECTED, self._node.connect(parse(payload)))
        elif kind in (Kind.PUBLISH, Kind.RUN):
            self._let_pass(*_TIME.unpack(payload), timers=kind == Kind.RUN)
        elif kind == Kind.START and self._node.real_time is not None:
            self._node.real_time.start(*_TIME.unpack(payload))
        elif kind == Kind.STOP and self._node.real_time is not None:
            self._node.real_time.end()
            self._node.wire.collect()
            self._answered += 1
            self._tell()
        elif kind == Kind.FINISH:
            self._finish(self._node)
        else:
            raise unexpected(kind)

    def _configure(self, configuration: dict[str, Any]) -> None:
        if self._node is not None:
            self._node.end()
        if self._clock is not None:
            self._clock.close()
        self._clock, self._shown = self._participant.reader(CLOCK_TOPIC, CLOCK_TYPE, QoSProfile(depth=1)), -1
        self._doorbell.wait_set.attach(self._clock)
        self._answered = 0
        clock = {"clock": self._clock.guid.hex()}
        self._node = node = NodeOnWire(configuration, self._participant, self._doorbell)
        self.start(node.start, lambda: {**node.ready(), **clock})

    def _finish(self, node: NodeOnWire) -> None:
        """Close the endpoints before answering: those of this scenario must not match those of the next."""
        finished = node.finished()
        node.wire.close()
        self.channel.write_json(Kind.FINISHED, finished)

    def _let_pass(self, until: int, *, timers: bool) -> None:
        assert self._node is not None
        self._wait_for_clock(until)
        self._node.wire.collect()
        self.limit()
        simulation = self._node.simulation
        if self._node.wire.has_samples:
            simulation.now = until
            self._node.wire.deliver()
        simulation.happen(until, timers=timers)
        self._answered += 1
        self._tell()

    def _wait_for_clock(self, until: int) -> None:
        """Wait until `/clock`, which gives a node's time, has reached this time: samples and clock are not ordered."""
        self._read_clock()
        while self._shown < until:
            select.select([self._doorbell.fileno()], [], [], _LOOK_SECONDS)
            self._read_clock()

    def _read_clock(self) -> None:
        if self._clock is not None:
            for sample in self._clock.take():
                seconds, nanoseconds = _CLOCK.unpack_from(sample.data, _CDR_HEADER)
                self._shown = seconds * _NANOSECONDS + nanoseconds


def main() -> int:
    """Serve standard input and output, with the prepared participant."""
    participant, doorbell = prepared.pop()
    return NodeHost(Channel.of_standard_streams(), participant, doorbell).run()


if __name__ == "__main__":
    sys.exit(main())
