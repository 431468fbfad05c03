"""The other ends of a participant's topics: warnings about problems with them, and those that are there."""

from __future__ import annotations

import sys
import threading
from time import monotonic_ns

from eventchain_ros2.dds_endpoints import Announced
from eventchain_ros2.dds_entities import ClosedError, Participant, Reader, WaitSet, Writer, dds_topic, ros_topic
from eventchain_ros2.definitions import message_name
from eventchain_ros2.discovery import Announcements
from eventchain_ros2.graph import GraphNode
from eventchain_ros2.qos import QoSProfile
from eventchain_ros2.simulation import End, Publisher, Subscription

_QUIET = 1_000_000_000
"""Time for which an end on the wire is silent about missed deadlines after it has told of one, in ns."""


_UNKNOWN = "_NODE_NAME_UNKNOWN_"


class Watch:
    """Warns of problems between writers and readers, in its own thread."""

    def __init__(self, participant: Participant) -> None:
        self._wait_set = WaitSet(participant)
        self._ends: list[Writer | Reader] = []
        self._told: dict[Writer | Reader, int] = {}  # times of missed deadlines
        self._told_types: set[tuple[type, Announced]] = set()
        self._others: dict[type, Announcements] = {
            Reader: participant.announced_writers(),
            Writer: participant.announced_readers(),
        }
        for others in self._others.values():
            self._wait_set.attach(others)
        threading.Thread(target=self._run, name="events", daemon=True).start()

    def add(self, end: Writer | Reader) -> None:
        """Start watching a writer or reader."""
        self._ends.append(end)
        self._wait_set.attach_events(end)
        self._wait_set.wake()  # others may have existed before

    def remove(self, end: Writer | Reader) -> None:
        """Stop watching it."""
        self._ends.remove(end)
        self._told.pop(end, None)

    def profiles(self, kind: type, end: Publisher | Subscription) -> list[QoSProfile]:
        """Return the policies of the other ends of a topic that have been discovered: for a reader, of the writers."""
        return self._others[kind].profiles(dds_topic(end.topic.name, end.qos_profile))

    def ends(self, nodes: list[GraphNode]) -> list[End]:
        """Return the writers and readers of the domain that belong to topics of ROS 2, with their nodes."""
        owners = {guid: node for node in nodes for guid in (*node.writers, *node.readers)}
        found = []
        for kind, others in self._others.items():
            for announced, profile, guid in others.known():
                topic = ros_topic(announced.topic)
                if topic:
                    owner = owners.get(guid)
                    name, namespace = (owner.name, owner.namespace) if owner else (_UNKNOWN, _UNKNOWN)
                    type_name = message_name(announced.type_name)
                    found.append(End(topic, type_name, kind is Reader, name, namespace, profile, guid))
        return sorted(found, key=lambda end: (end.topic, not end.publishes, end.namespace, end.node, end.gid))

    def _run(self) -> None:
        try:
            while True:
                self._wait_set.wait(None)
                others = {kind: announced.there() for kind, announced in self._others.items()}
                for end in list(self._ends):
                    self._look_at(end)
                    self._compare_types(end, others[type(end)])
        except ClosedError:
            return

    def _look_at(self, end: Writer | Reader) -> None:
        try:
            policy, missed, peers = end.incompatible(), end.missed_deadlines(), end.new_peers()
            _ = end.lost_liveliness() if isinstance(end, Writer) else end.lost_writers()
        except ClosedError:
            return  # the next wait reports whether there is more
        if policy:
            _warn(_INCOMPATIBLE[type(end)].format(topic=end.topic, policy=policy))
        if missed and monotonic_ns() - self._told.get(end, -_QUIET) >= _QUIET:
            self._told[end] = monotonic_ns()
            _warn(f"Deadline missed on topic '{end.topic}': {_MISSED[type(end)]}")
        for peer in peers:
            if peer.type_hash and end.type_hash and peer.type_hash != end.type_hash:
                _warn(
                    f"The definition of {peer.type_name} on topic '{end.topic}' differs between both sides: "
                    f"the type hash is {end.type_hash} here and {peer.type_hash} there"
                )

    def _compare_types(self, end: Writer | Reader, others: set[Announced]) -> None:
        topic, own = end.announced
        for other in sorted(others):
            if other.topic == topic and other.type_name != own and (type(end), other) not in self._told_types:
                self._told_types.add((type(end), other))
                names = {"other": message_name(other.type_name), "own": message_name(own)}
                _warn(_OTHER_TYPE[type(end)].format(topic=end.topic, **names))


_INCOMPATIBLE: dict[type, str] = {
    Reader: "New publisher discovered on topic '{topic}', offering incompatible QoS. No messages will be received "
    "from it. Last incompatible policy: {policy}",
    Writer: "New subscription discovered on topic '{topic}', requesting incompatible QoS. No messages will be sent "
    "to it. Last incompatible policy: {policy}",
}
_OTHER_TYPE: dict[type, str] = {
    Reader: "New publisher discovered on topic '{topic}', publishing {other} instead of {own}. No messages will be "
    "received from it",
    Writer: "New subscription discovered on topic '{topic}', expecting {other} instead of {own}. No messages will be "
    "sent to it",
}
_MISSED: dict[type, str] = {Reader: "nothing was received in time", Writer: "nothing was published in time"}


def _warn(text: str) -> None:
    sys.stderr.write(f"[WARN] {text}\n")  # in one piece, since nodes write from their own threads
    sys.stderr.flush()
