"""Nodes, with the supported part of `rclpy.node.Node`."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from eventchain_ros2 import context
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND, Clock, ROSClock
from eventchain_ros2.endpoints import GuardCondition, Publisher, Rate, Subscription, Timer
from eventchain_ros2.logger import Logger
from eventchain_ros2.node_parameters import ParameterMethods
from eventchain_ros2.parameters import Parameter
from eventchain_ros2.qos import QoSProfile, as_profile, qos_profile_services_default

if TYPE_CHECKING:
    from eventchain_ros2.simulation import Process

_NODE_NAME = re.compile(r"[A-Za-z_]\w*\Z", re.ASCII)
_TOPIC_NAME = re.compile(r"(~/|/)?[A-Za-z_]\w*(/[A-Za-z_]\w*)*\Z", re.ASCII)


class InvalidNodeNameException(ValueError):  # noqa: N818 - rclpy's name
    """An invalid node name."""


class InvalidTopicNameException(ValueError):  # noqa: N818 - rclpy's name
    """An invalid topic name."""


class InvalidServiceNameException(ValueError):  # noqa: N818 - rclpy's name
    """An invalid service name."""


class Node(ParameterMethods):
    """A node; it belongs to the process that the lock-step host starts, or to its own one.

    What this runtime does not have of `rclpy.node.Node` is refused with `NotImplementedError`.
    """

    def __init__(
        self,
        node_name: str,
        *,
        namespace: str = "",
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        **options: object,
    ) -> None:
        unknown = set(options) - _IGNORED_OPTIONS
        if unknown:
            raise TypeError(f"Node() got an unexpected keyword argument '{min(unknown)}'")
        if not _NODE_NAME.match(node_name):
            raise InvalidNodeNameException(f"Invalid node name: '{node_name}'")
        self.__simulation = context.current()
        self.__process = self.__simulation.process_of_new_node(node_name)
        launched = self.__process.launched
        self.__name = node_name = launched.name or node_name
        self.__namespace = self.__process.namespace = "/" + (launched.namespace or namespace).strip("/")
        self.__remappings = {self.__expanded(used): full for used, full in launched.remappings.items()}
        overrides = [*self.__simulation.overrides(node_name), *launched.overrides(), *(parameter_overrides or [])]
        self._start_parameters(overrides, undeclared=allow_undeclared_parameters)
        if self.declare_parameter("use_sim_time", self.__simulation.is_simulated).value:
            self.__simulation.follow_clock()
        if automatically_declare_parameters_from_overrides:
            self._declare_overrides()
        self.executor: Any = None
        self.__services: list[Any] = []
        self.__clients: list[Any] = []
        self.__guards: list[GuardCondition] = []
        self.__publishers: list[Publisher] = []
        self.__subscriptions: list[Subscription] = []
        self.__timers: list[Timer] = []
        self.__clock = ROSClock(now=self.__now)
        self.__default_group: Any = None
        self.__logger = Logger(self.get_fully_qualified_name().strip("/").replace("/", "."), self.__now)

    def __now(self) -> int:
        return self.__simulation.clock(self.__process)

    @property
    def _eventchain_process(self) -> Process:
        """Return the process that runs this node's callbacks, for executors."""
        return self.__process

    def get_name(self) -> str:
        """Return the name without the namespace."""
        return self.__name

    def get_namespace(self) -> str:
        """Return the namespace, `/` by default."""
        return self.__namespace

    def get_fully_qualified_name(self) -> str:
        """Return the namespace and the name."""
        return f"{self.__namespace.rstrip('/')}/{self.__name}"

    def get_logger(self) -> Logger:
        """Return the logger of this node."""
        return self.__logger

    def get_clock(self) -> Clock:
        """Return the clock of this node; it shows the simulated time."""
        return self.__clock

    @property
    def context(self) -> context.Context:
        """Return the context of this node."""
        return context.default

    @property
    def default_callback_group(self) -> Any:
        """Return the group of callbacks that name none."""
        if self.__default_group is None:
            from eventchain_ros2.callback_groups import MutuallyExclusiveCallbackGroup

            self.__default_group = MutuallyExclusiveCallbackGroup()
        return self.__default_group

    @property
    def services(self) -> list[Any]:
        """Return the services of this node."""
        return list(self.__services)

    @property
    def clients(self) -> list[Any]:
        """Return the clients of this node."""
        return list(self.__clients)

    @property
    def guards(self) -> list[GuardCondition]:
        """Return the guard conditions of this node."""
        return list(self.__guards)

    @property
    def publishers(self) -> list[Publisher]:
        """Return the publishers of this node."""
        return list(self.__publishers)

    @property
    def subscriptions(self) -> list[Subscription]:
        """Return the subscriptions of this node."""
        return list(self.__subscriptions)

    @property
    def timers(self) -> list[Timer]:
        """Return the timers of this node."""
        return list(self.__timers)

    def create_publisher(
        self,
        msg_type: type,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: object = None,
        event_callbacks: object = None,
        qos_overriding_options: object = None,
    ) -> Publisher:
        """Create a publisher; an int as `qos_profile` is the depth of the default profile."""
        self.__require(callback_group, event_callbacks, qos_overriding_options)
        name = self.__topic_name(topic)
        publisher = Publisher(self.__simulation, self.__process, msg_type, name, as_profile(qos_profile))
        self.__publishers.append(publisher)
        return publisher

    def create_subscription(
        self,
        msg_type: type,
        topic: str,
        callback: Callable[[Any], object],
        qos_profile: QoSProfile | int,
        *,
        callback_group: object = None,
        event_callbacks: object = None,
        qos_overriding_options: object = None,
        raw: bool = False,
    ) -> Subscription:
        """Create a subscription; with `raw` the callback receives the CDR bytes."""
        self.__require(callback_group, event_callbacks, qos_overriding_options)
        name, profile = self.__topic_name(topic), as_profile(qos_profile)
        subscription = Subscription(self.__simulation, self.__process, msg_type, name, callback, profile, raw=raw)
        self.__subscriptions.append(subscription)
        return subscription

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[[], object],
        callback_group: object = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer with a period in seconds."""
        self.__require(callback_group)
        period = _period(timer_period_sec, "timer")
        timer = Timer(self.__simulation, self.__process, period, callback, autostart=autostart)
        self.__timers.append(timer)
        return timer

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate with a frequency in Hz, for a loop outside of callbacks."""
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        return Rate(self.__simulation, _period(1 / frequency, "rate"), self.__now)

    def create_guard_condition(self, callback: Callable[[], object], callback_group: object = None) -> GuardCondition:
        """Create a condition that runs a callback when it is triggered."""
        self.__require(callback_group)
        guard = GuardCondition(self.__simulation, self.__process, callback)
        self.__guards.append(guard)
        return guard

    def create_service(
        self,
        srv_type: Any,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: object = None,
    ) -> Any:
        """Offer a service, an `eventchain_ros2.services.Service`: the callback returns the response to a request."""
        from eventchain_ros2.services import Service

        self.__require(callback_group)
        name = self.__service_name(srv_name)
        service = Service(self.__simulation, self.__process, _service_type(srv_type), name, callback, qos_profile)
        self.__services.append(service)
        return service

    def create_client(
        self,
        srv_type: Any,
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: object = None,
    ) -> Any:
        """Create a client of a service, an `eventchain_ros2.services.Client`."""
        from eventchain_ros2.services import Client

        self.__require(callback_group)
        name = self.__service_name(srv_name)
        client = Client(self.__simulation, self.__process, _service_type(srv_type), name, qos_profile)
        self.__clients.append(client)
        return client

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Stop publishing; return whether the publisher belongs to this node."""
        return _remove(publisher, self.__publishers)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Stop receiving; return whether the subscription belongs to this node."""
        return _remove(subscription, self.__subscriptions)

    def destroy_timer(self, timer: Timer) -> bool:
        """Stop the timer; return whether it belongs to this node."""
        return _remove(timer, self.__timers)

    def destroy_service(self, service: Any) -> bool:
        """Stop offering a service; return whether it belongs to this node."""
        return _remove(service, self.__services)

    def destroy_client(self, client: Any) -> bool:
        """Stop using a service; return whether the client belongs to this node."""
        return _remove(client, self.__clients)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; return whether it belongs to this node."""
        return _remove(guard, self.__guards)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate."""
        rate.destroy()
        return True

    def destroy_node(self) -> None:
        """Destroy all entities of this node."""
        owned: tuple[list[Any], ...] = (self.__timers, self.__guards, self.__services, self.__clients)
        for things in (*owned, self.__subscriptions, self.__publishers):
            for thing in list(things):
                _remove(thing, things)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service for this node."""
        return self.__service_name(service)

    def __service_name(self, service: str) -> str:
        try:
            return self.__topic_name(service)
        except InvalidTopicNameException:
            raise InvalidServiceNameException(f"Invalid service name: '{service}'") from None

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic for this node."""
        return self.__expanded(topic) if only_expand else self.__topic_name(topic)

    def __require(
        self, callback_group: object, event_callbacks: object = None, qos_overriding_options: object = None
    ) -> None:
        _refuse(event_callbacks, "event callbacks")
        _refuse(qos_overriding_options, "QoS overriding options")
        if callback_group is not None:
            from eventchain_ros2.callback_groups import require_known

            require_known(callback_group)

    def __topic_name(self, topic: str) -> str:
        full = self.__expanded(topic)
        return self.__remappings.get(full, full)

    def __expanded(self, topic: str) -> str:
        if not _TOPIC_NAME.match(topic) or "__" in topic:
            raise InvalidTopicNameException(f"Invalid topic name: '{topic}'")
        if topic.startswith("/"):
            return topic
        if topic.startswith("~"):
            return self.get_fully_qualified_name() + topic[1:]
        return f"{self.__namespace.rstrip('/')}/{topic}"

    def __getattr__(self, name: str) -> Any:
        if name in _QUERIES:
            from eventchain_ros2.node_graph import GraphQueries

            return getattr(GraphQueries(self.__simulation, self.__topic_name), name)
        if name in _REFUSED:
            _refuse(name, _REFUSED[name])
        raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")


_IGNORED_OPTIONS = {
    "cli_args",
    "context",
    "enable_logger_service",
    "enable_rosout",
    "rosout_qos_profile",
    "start_parameter_services",
    "use_global_arguments",
}
_QUERIES = {
    "count_clients",
    "count_publishers",
    "count_services",
    "count_subscribers",
    "get_client_names_and_types_by_node",
    "get_fully_qualified_node_names",
    "get_node_names",
    "get_node_names_and_namespaces",
    "get_publisher_names_and_types_by_node",
    "get_publishers_info_by_topic",
    "get_service_names_and_types",
    "get_service_names_and_types_by_node",
    "get_subscriber_names_and_types_by_node",
    "get_subscriptions_info_by_topic",
    "get_topic_names_and_types",
    "wait_for_node",
}
"""Methods of `node_graph`, which few nodes need: it is loaded when the first is called."""
_REFUSED = {
    "add_waitable": "waitables",
    "create_lifecycle_publisher": "managed nodes",
    "get_servers_info_by_service": "descriptions of services",
    "get_clients_info_by_service": "descriptions of services",
    "handle": "handles of rcl",
    "remove_waitable": "waitables",
    "waitables": "waitables",
}


def _period(seconds: float, what: str) -> int:
    period = int(float(seconds) * NANOSECONDS_PER_SECOND)
    if period <= 0:
        raise ValueError(f"a {what} needs a period of at least a nanosecond, not {seconds} s")
    return period


def _service_type(service_type: Any) -> Any:
    """Return the type of a service, if it is one of this runtime's."""
    if not (hasattr(service_type, "Request") and hasattr(service_type, "Response")):
        raise TypeError(f"{service_type!r} is not a type of services, as `from PACKAGE.srv import NAME` gives it")
    return service_type


def _refuse(value: object, feature: str) -> None:
    if value is not None:
        raise NotImplementedError(f"{feature} are not part of Eventchain's runtime")


def _remove(thing: Any, things: list[Any]) -> bool:
    if thing not in things:
        return False
    things.remove(thing)
    thing.destroy()
    return True
