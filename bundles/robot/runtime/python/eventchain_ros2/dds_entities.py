"""Participants, writers, readers and wait sets on the wire, with the conventions of ROS 2.

Samples are CDR version 1 with a header of four bytes. Entities may be used from several threads. Wrong use raises an
exception; it never reaches the library.
"""

from __future__ import annotations

import threading
from types import TracebackType

from eventchain_ros2 import cyclone, discovery, graph
from eventchain_ros2.catalog import Catalog
from eventchain_ros2.cyclone import checked
from eventchain_ros2.dds_endpoints import (
    Announced,
    ClosedError,
    Lifetime,
    Peer,
    Reader,
    Received,
    Writer,
    guid_of,
    in_slices,
)
from eventchain_ros2.dds_qos import dds_qos
from eventchain_ros2.definitions import Definition
from eventchain_ros2.discovery import Announcements
from eventchain_ros2.graph import GraphNode
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from eventchain_ros2.type_support import dds_type_name, descriptor, is_of_service, type_hash, with_identity

HIGHEST_DOMAIN = 232
"""The ports of domains with higher numbers do not exist (RTPS 2.5, section 9.6.2.3)."""


SERVICE_PREFIXES = ("rq/", "rr/")
"""Beginnings of the topics of services, for requests and replies: they are the same in this runtime and on DDS."""


class _Domain:
    """A domain of this process with its configuration, shared by participants of the same configuration."""

    _open: dict[int, _Domain] = {}  # noqa: RUF012 - one per process, as in the library
    _lock = threading.Lock()

    def __init__(self, number: int, configuration: str) -> None:
        made = cyclone.load().dds_create_domain(number, configuration.encode())
        self.handle = checked(made, f"domain {number}")
        self.configuration = configuration
        self.users = 0

    @classmethod
    def enter(cls, number: int, configuration: str) -> None:
        with cls._lock:
            domain = cls._open.get(number)
            if domain is None:
                domain = cls._open[number] = cls(number, configuration)
            elif domain.configuration != configuration:
                raise ValueError(f"domain {number} of this process has another configuration")
            domain.users += 1

    @classmethod
    def leave(cls, number: int) -> None:
        with cls._lock:
            domain = cls._open[number]
            domain.users -= 1
            if not domain.users:
                del cls._open[number]
                cyclone.load().dds_delete(domain.handle)


def dds_topic(topic: str, profile: QoSProfile) -> str:
    """Return the name on the wire of a topic of ROS 2: that of `/scan` is `rt/scan`."""
    if topic == graph.TOPIC or profile.avoid_ros_namespace_conventions or topic.startswith(SERVICE_PREFIXES):
        return topic
    return f"rt/{topic.lstrip('/')}"


def ros_topic(name: str) -> str:
    """Return the name in ROS 2 of a topic on the wire, that of a service's unchanged; empty: it has none."""
    if name.startswith(SERVICE_PREFIXES):
        return name
    return name[2:] if name.startswith("rt/") else ""


class Participant:
    """Participant of a domain. Its sockets and threads exist once it is created.

    Args:
        domain: number of the domain.
        configuration_xml: Cyclone DDS configuration; if empty, that of `CYCLONEDDS_URI`.
        catalog: the available message types; the standard ones by default.
        ignore_own: whether its readers ignore its own writers.

    Raises:
        LibraryUnavailableError: there is no Cyclone DDS.
        DdsError: the domain or the configuration cannot be used.
        ValueError: this process uses the domain with another configuration.

    """

    def __init__(
        self,
        domain: int,
        configuration_xml: str = "",
        catalog: Catalog | None = None,
        *,
        ignore_own: bool = False,
    ) -> None:
        if not 0 <= domain <= HIGHEST_DOMAIN:
            raise ValueError(f"{domain} is not the number of a domain (0 to {HIGHEST_DOMAIN})")
        self._library = cyclone.load()
        self._ignore_own = ignore_own
        self._catalog = catalog or Catalog()
        self._gid_size = graph.gid_size()
        self._graph_types = {each.name: each for each in graph.definitions(self._gid_size)}
        self._topics: dict[tuple[str, str], int] = {}
        self._nodes: dict[tuple[str, str], GraphNode] = {}
        self._others: dict[int, list[GraphNode]] = {}
        self._graph: tuple[Writer, Reader] | None = None
        self._domain = domain if configuration_xml else None
        self.lifetime = Lifetime()
        if configuration_xml:
            _Domain.enter(domain, configuration_xml)
        try:
            with dds_qos(QoSProfile(depth=1), b"enclave=/;") as qos:
                made = self._library.dds_create_participant(domain, qos, None)
            self.handle = checked(made, f"a participant of domain {domain}")
            self.guid = guid_of(self.handle)
        except BaseException:
            self._leave_domain()
            raise

    def __enter__(self) -> Participant:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, problem: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def definition(self, type_name: str) -> Definition:
        """Return the definition of a message type.

        Raises:
            KeyError: there is none.

        """
        found = self._graph_types.get(type_name) or self._catalog.find(type_name)
        if found is None:
            raise KeyError(type_name)
        return with_identity(found) if is_of_service(type_name) else found

    def writer(self, topic: str, type_name: str, qos_profile: QoSProfile, owner: str = "") -> Writer:
        """Create a writer.

        Args:
            topic: full name in ROS 2, such as `/scan`; on the wire it is `rt/scan`.
            type_name: full name of the message type, such as `sensor_msgs/msg/LaserScan`.
            qos_profile: the offered policies.
            owner: the client or server that it belongs to, such as `clientid=1f`, equal for its two ends.

        Raises:
            KeyError: no such message type.
            ClosedError: the participant is closed.
            DdsError: Cyclone DDS refuses it.

        """
        return Writer(self.lifetime, *self._make("dds_create_writer", topic, type_name, qos_profile, owner))

    def reader(self, topic: str, type_name: str, qos_profile: QoSProfile, owner: str = "") -> Reader:
        """Create a reader; see `writer`."""
        return Reader(self.lifetime, *self._make("dds_create_reader", topic, type_name, qos_profile, owner))

    def _make(
        self, function: str, topic: str, type_name: str, profile: QoSProfile, owner: str
    ) -> tuple[int, str, str, Announced]:
        hashed = "" if is_of_service(type_name) else type_hash(type_name, self.definition)
        name = dds_topic(topic, profile)
        announced = f"typehash={hashed}" if hashed else owner
        user_data = f"{announced};".encode() if announced else b""
        with self.lifetime.opened(), dds_qos(profile, user_data, ignore_own=self._ignore_own) as qos:
            made = getattr(self._library, function)(self.handle, self._topic(name, type_name), qos, None)
        return checked(made, f"topic {topic}"), topic, hashed, Announced(name, dds_type_name(type_name))

    def _topic(self, name: str, type_name: str) -> int:
        if (name, type_name) not in self._topics:
            with descriptor(self.handle, type_name, self.definition) as made:
                topic = self._library.dds_create_topic(self.handle, made, name.encode(), None, None)
            self._topics[name, type_name] = checked(topic, f"topic {name}")
        return self._topics[name, type_name]

    def announced_writers(self) -> Announcements:
        """Return the writers of the domain, including those of this participant."""
        return Announcements(self.lifetime, self.handle, discovery.WRITERS)

    def announced_readers(self) -> Announcements:
        """Return the readers of the domain, including those of this participant."""
        return Announcements(self.lifetime, self.handle, discovery.READERS)

    def announce(self, node_name: str, namespace: str, writers: list[Writer], readers: list[Reader]) -> None:
        """Announce the writers and readers of a node in the ROS graph, replacing earlier announcements."""
        guids = tuple(each.guid for each in writers), tuple(each.guid for each in readers)
        with self.lifetime.opened():
            self._nodes[namespace, node_name] = GraphNode(node_name, namespace, self.guid, *guids)
            writer, _ = self._graph_endpoints()
            writer.write(graph.encode(self.guid, list(self._nodes.values()), self._gid_size), None)

    def nodes(self, *, own: bool = False) -> list[GraphNode]:
        """Return the nodes announced so far by other participants that still exist, and on request its own."""
        with self.lifetime.opened():
            _, reader = self._graph_endpoints()
            for received in reader.take():
                self._others[received.publication] = graph.decode(received.data, self._gid_size)
            there = {peer.handle for peer in reader.peers()}
            self._others = {handle: nodes for handle, nodes in self._others.items() if handle in there}
            found = [node for nodes in self._others.values() for node in nodes if node.participant != self.guid]
        return sorted([*found, *(self._nodes.values() if own else ())])

    def _graph_endpoints(self) -> tuple[Writer, Reader]:
        if self._graph is None:
            last = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            every = QoSProfile(history=HistoryPolicy.KEEP_ALL, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            self._graph = self.writer(graph.TOPIC, graph.TYPE, last), self.reader(graph.TOPIC, graph.TYPE, every)
        return self._graph

    def close(self) -> None:
        """Leave the domain, with all entities of this participant. Closing twice has no effect."""
        with self.lifetime.lock:
            if self.lifetime.is_open:
                self.lifetime.is_open = False
                self._library.dds_delete(self.handle)
                self._leave_domain()

    def _leave_domain(self) -> None:
        if self._domain is not None:
            _Domain.leave(self._domain)


class WaitSet:
    """Waits for events of a participant's entities."""

    def __init__(self, participant: Participant) -> None:
        self._lifetime = participant.lifetime
        self._is_woken = False
        self._library = cyclone.load()
        with self._lifetime.opened():
            self._handle = checked(self._library.dds_create_waitset(participant.handle), "wait set")
            self._guard = checked(self._library.dds_create_guardcondition(participant.handle), "guard condition")
            self._attach(self._guard)

    def attach(self, reader: Reader | Announcements) -> None:
        """Add an entity with readable samples; until they are taken, waits end at once."""
        with reader.opened():
            self._attach(reader.condition)

    def attach_events(self, endpoint: Reader | Writer) -> None:
        """Add the events of an endpoint, until all are read: `incompatible`, deadlines, liveliness, `new_peers`."""
        with endpoint.opened():
            checked(self._library.dds_set_status_mask(endpoint.handle, endpoint.event_mask), endpoint.topic)
            self._attach(endpoint.handle)

    def _attach(self, handle: int) -> None:
        checked(self._library.dds_waitset_attach(self._handle, handle, handle), "wait set")

    def wait(self, timeout_ns: int | None) -> bool:
        """Wait for an event, at most for this time (None: unlimited); return whether there was one.

        Raises:
            ClosedError: the participant is closed, or was meanwhile.

        """
        return in_slices(timeout_ns, self._wait)

    def _wait(self, timeout_ns: int) -> bool:
        code = self._library.dds_waitset_wait(self._handle, None, 0, 0 if self._is_woken else timeout_ns)
        with self._lifetime.opened():
            is_woken, self._is_woken = self._is_woken, False
            if is_woken:
                self._library.dds_set_guardcondition(self._guard, False)
        return is_woken or checked(code, "wait set") > 0

    def wake(self) -> None:
        """End the current wait, or else the next one; usable from another thread."""
        with self._lifetime.opened():
            self._is_woken = True  # also reaches callers between two parts of a wait, such as signal handlers
            checked(self._library.dds_set_guardcondition(self._guard, True), "guard condition")


__all__ = [
    "ClosedError",
    "Participant",
    "Peer",
    "Reader",
    "Received",
    "WaitSet",
    "Writer",
]
