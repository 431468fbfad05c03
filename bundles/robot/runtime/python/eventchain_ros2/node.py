"""Nodes, with the supported part of `rclpy.node.Node`."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from eventchain_ros2 import context
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND, Clock, ClockType
from eventchain_ros2.endpoints import Publisher, Subscription, Timer
from eventchain_ros2.logger import Logger
from eventchain_ros2.parameters import Parameter, Parameters
from eventchain_ros2.qos import QoSProfile, as_profile

if TYPE_CHECKING:
    from eventchain_ros2.simulation import Process

_NODE_NAME = re.compile(r"[A-Za-z_]\w*\Z", re.ASCII)
_TOPIC_NAME = re.compile(r"(~/|/)?[A-Za-z_]\w*(/[A-Za-z_]\w*)*\Z", re.ASCII)


class InvalidNodeNameException(ValueError):  # noqa: N818 - rclpy's name
    """An invalid node name."""


class InvalidTopicNameException(ValueError):  # noqa: N818 - rclpy's name
    """An invalid topic name."""


class Node:
    """A node; it belongs to the process that the lock-step host starts, or to its own one.

    Services, actions, guard conditions, rates and event callbacks are refused with `NotImplementedError`.
    """

    def __init__(
        self,
        node_name: str,
        *,
        namespace: str = "",
        parameter_overrides: list[Parameter] | None = None,
        **options: object,
    ) -> None:
        unknown = set(options) - _IGNORED_OPTIONS
        if unknown:
            raise TypeError(f"Node() got an unexpected keyword argument '{min(unknown)}'")
        if not _NODE_NAME.match(node_name):
            raise InvalidNodeNameException(f"Invalid node name: '{node_name}'")
        self.__simulation = context.current()
        self.__process = self.__simulation.process_of_new_node(node_name)
        self.__name = node_name
        self.__namespace = self.__process.namespace = "/" + namespace.strip("/")
        self.__parameters = Parameters([*self.__simulation.overrides(node_name), *(parameter_overrides or [])])
        if self.__parameters.declare("use_sim_time", self.__simulation.is_simulated).value:
            self.__simulation.follow_clock()
        self.__publishers: list[Publisher] = []
        self.__subscriptions: list[Subscription] = []
        self.__timers: list[Timer] = []
        self.__clock = Clock(clock_type=ClockType.ROS_TIME, now=self.__now)
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
        _refuse(event_callbacks, "event callbacks")
        _refuse(qos_overriding_options, "QoS overriding options")
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
        _refuse(event_callbacks, "event callbacks")
        _refuse(qos_overriding_options, "QoS overriding options")
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
    ) -> Timer:
        """Create a timer with a period in seconds."""
        period = int(float(timer_period_sec) * NANOSECONDS_PER_SECOND)
        if period <= 0:
            raise ValueError(f"a timer needs a period of at least a nanosecond, not {timer_period_sec} s")
        timer = Timer(self.__simulation, self.__process, period, callback)
        self.__timers.append(timer)
        return timer

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Stop publishing; return whether the publisher belongs to this node."""
        return _remove(publisher, self.__publishers)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Stop receiving; return whether the subscription belongs to this node."""
        return _remove(subscription, self.__subscriptions)

    def destroy_timer(self, timer: Timer) -> bool:
        """Stop the timer; return whether it belongs to this node."""
        return _remove(timer, self.__timers)

    def destroy_node(self) -> None:
        """Destroy all entities of this node."""
        for things in (self.__timers, self.__subscriptions, self.__publishers):
            for thing in list(things):
                _remove(thing, things)

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: object = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare a parameter with its default value; ranges and `read_only` of the descriptor are enforced."""
        return self.__parameters.declare(name, value, descriptor, ignore_override=ignore_override)

    def declare_parameters(self, namespace: str, parameters: list[tuple[Any, ...]]) -> list[Parameter]:
        """Declare several parameters, given as `(name, value, descriptor)`, where the last ones are optional."""
        prefix = f"{namespace}." if namespace else ""
        return [self.__parameters.declare(prefix + name, *rest or [None]) for name, *rest in parameters]

    def has_parameter(self, name: str) -> bool:
        """Return whether the parameter is declared."""
        return name in self.__parameters

    def get_parameter(self, name: str) -> Parameter:
        """Return the declared parameter of this name."""
        return self.__parameters.get(name)

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return the declared parameter of this name; without one, the alternative, or a parameter without a value."""
        if name in self.__parameters:
            return self.__parameters.get(name)
        return Parameter(name) if alternative_value is None else alternative_value

    def undeclare_parameter(self, name: str) -> None:
        """Forget a declared parameter that is not read-only."""
        self.__parameters.undeclare(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return the declared parameters of these names."""
        return [self.__parameters.get(name) for name in names]

    def set_parameters(self, parameters: list[Parameter]) -> list[Any]:
        """Set declared parameters; return a `rcl_interfaces/msg/SetParametersResult` for each."""
        from rcl_interfaces.msg import SetParametersResult  # type: ignore[import-not-found]

        reasons = [self.__parameters.set(parameter) for parameter in parameters]
        return [SetParametersResult(successful=not reason, reason=reason) for reason in reasons]

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic for this node."""
        return self.__topic_name(topic)

    def __topic_name(self, topic: str) -> str:
        if not _TOPIC_NAME.match(topic) or "__" in topic:
            raise InvalidTopicNameException(f"Invalid topic name: '{topic}'")
        if topic.startswith("/"):
            return topic
        if topic.startswith("~"):
            return self.get_fully_qualified_name() + topic[1:]
        return f"{self.__namespace.rstrip('/')}/{topic}"

    def __getattr__(self, name: str) -> Any:
        if name in _REFUSED:
            _refuse(name, _REFUSED[name])
        raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")


_IGNORED_OPTIONS = {
    "allow_undeclared_parameters",
    "automatically_declare_parameters_from_overrides",
    "cli_args",
    "context",
    "enable_rosout",
    "start_parameter_services",
    "use_global_arguments",
}
_REFUSED = {
    "create_service": "services",
    "create_client": "services",
    "create_guard_condition": "guard conditions",
    "create_rate": "rates",
    "add_on_set_parameters_callback": "parameter callbacks",
    "describe_parameter": "descriptions of parameters",
    "describe_parameters": "descriptions of parameters",
    "add_post_set_parameters_callback": "parameter callbacks",
    "add_pre_set_parameters_callback": "parameter callbacks",
    "get_topic_names_and_types": "queries of the graph",
    "get_node_names": "queries of the graph",
    "get_node_names_and_namespaces": "queries of the graph",
    "get_publishers_info_by_topic": "queries of the graph",
    "get_subscriptions_info_by_topic": "queries of the graph",
    "count_publishers": "queries of the graph",
    "count_subscribers": "queries of the graph",
    "get_service_names_and_types": "services",
    "wait_for_node": "queries of the graph",
    "executor": "executors",
}


def _refuse(value: object, feature: str) -> None:
    if value is not None:
        raise NotImplementedError(f"{feature} are not part of Eventchain's runtime")


def _remove(thing: Any, things: list[Any]) -> bool:
    if thing not in things:
        return False
    things.remove(thing)
    thing.destroy()
    return True
