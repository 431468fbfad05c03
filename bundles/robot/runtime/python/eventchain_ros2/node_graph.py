"""The queries of the ROS graph that nodes have: which nodes, topics and services there are."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from eventchain_ros2.qos import QoSProfile
from eventchain_ros2.services import REQUEST, service_of

if TYPE_CHECKING:
    from eventchain_ros2.simulation import End, Simulation


class TopicEndpointInfo(NamedTuple):
    """A publisher or subscription, as `get_publishers_info_by_topic` describes it."""

    node_name: str
    node_namespace: str
    topic_type: str
    endpoint_type: int
    endpoint_gid: list[int]
    qos_profile: QoSProfile


_PUBLISHER, _SUBSCRIPTION = 1, 2  # rmw_endpoint_type_t
NamesAndTypes = list[tuple[str, list[str]]]


class GraphQueries:
    """The methods of a node about the graph.

    In lock-step, they know everything that nodes have made so far; on DDS, what has been discovered.

    Args:
        simulation: that of the node.
        topic_name: returns the full name of a topic or service for the node.

    """

    def __init__(self, simulation: Simulation, topic_name: Callable[[str], str]) -> None:
        self._simulation = simulation
        self._topic_name = topic_name

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics, and the types published or subscribed on them."""
        return _named(end for end in self._simulation.ends() if _is_topic(end))

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services, and their types."""
        return _services(end for end in self._simulation.ends() if not end.publishes)

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node publishes."""
        return _named(end for end in self._ends_of(node_name, node_namespace) if _is_topic(end) and end.publishes)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics that a node subscribes to."""
        return _named(end for end in self._ends_of(node_name, node_namespace) if _is_topic(end) and not end.publishes)

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node offers."""
        return _services(end for end in self._ends_of(node_name, node_namespace) if not end.publishes)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services that a node has clients of."""
        return _services(end for end in self._ends_of(node_name, node_namespace) if end.publishes)

    def _ends_of(self, name: str, namespace: str) -> list[End]:
        return [end for end in self._simulation.ends() if (end.node, end.namespace) == (name, namespace)]

    def count_publishers(self, topic_name: str) -> int:
        """Return the number of publishers on a topic."""
        return len(self.get_publishers_info_by_topic(topic_name))

    def count_subscribers(self, topic_name: str) -> int:
        """Return the number of subscriptions of a topic."""
        return len(self.get_subscriptions_info_by_topic(topic_name))

    def count_services(self, service_name: str) -> int:
        """Return how many nodes offer a service."""
        return self._count(REQUEST.topic(self._topic_name(service_name)), publishes=False)

    def count_clients(self, service_name: str) -> int:
        """Return the number of clients of a service."""
        return self._count(REQUEST.topic(self._topic_name(service_name)), publishes=True)

    def _count(self, topic: str, *, publishes: bool) -> int:
        return sum((end.topic, end.publishes) == (topic, publishes) for end in self._simulation.ends())

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Describe the publishers on a topic."""
        return self._described(topic_name, publishes=True)

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Describe the subscriptions of a topic."""
        return self._described(topic_name, publishes=False)

    def _described(self, topic: str, *, publishes: bool) -> list[TopicEndpointInfo]:
        name, kind = self._topic_name(topic), _PUBLISHER if publishes else _SUBSCRIPTION
        return [
            TopicEndpointInfo(end.node, end.namespace, end.type_name, kind, list(end.gid), end.qos_profile)
            for end in self._simulation.ends()
            if (end.topic, end.publishes) == (name, publishes)
        ]

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes."""
        return [name for name, _ in self.get_node_names_and_namespaces()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return the names and namespaces of all nodes."""
        return self._simulation.node_names()

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return [f"{namespace.rstrip('/')}/{name}" for name, namespace in self.get_node_names_and_namespaces()]

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Return whether there is a node, within a time in seconds."""
        name = "/" + fully_qualified_node_name.lstrip("/")
        return self._simulation.wait_until(lambda: name in self.get_fully_qualified_node_names(), timeout)


def _is_topic(end: End) -> bool:
    return end.topic.startswith("/")


def _named(ends: Iterable[End]) -> NamesAndTypes:
    found: dict[str, set[str]] = {}
    for end in ends:
        found.setdefault(end.topic, set()).add(end.type_name)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


def _services(ends: Iterable[End]) -> NamesAndTypes:
    requests: list[Any] = []
    for end in ends:
        if REQUEST.is_topic(end.topic):
            name, type_name = service_of(end.topic, end.type_name)
            requests.append(end._replace(topic=name, type_name=type_name))
    return _named(requests)
