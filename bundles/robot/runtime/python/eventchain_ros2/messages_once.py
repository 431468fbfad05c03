"""Waiting for one message, as `rclpy.wait_for_message`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from eventchain_ros2.context import current
from eventchain_ros2.endpoints import Subscription
from eventchain_ros2.qos import QoSProfile, as_profile
from eventchain_ros2.tasks import Future

if TYPE_CHECKING:
    from eventchain_ros2.node import Node

_NANOSECONDS = 1e9


def wait_for_message(
    msg_type: type, node: Node, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: float = -1
) -> tuple[bool, Any]:
    """Return whether a message has arrived within a time, and it; no other callback runs meanwhile.

    Args:
        msg_type: type of the message.
        node: the node that wants it.
        topic: its topic.
        qos_profile: quality of service of the subscription.
        time_to_wait: longest time, in s; negative: no limit.

    Raises:
        RuntimeError: a callback wants to wait in simulated time.

    """
    simulation = current()
    process = simulation.add_process(node.get_name())
    process.namespace = node.get_namespace()
    received = Future()
    name = node.resolve_topic_name(topic)
    subscription = Subscription(simulation, process, msg_type, name, received.set_result, as_profile(qos_profile))
    try:
        limit = None if time_to_wait < 0 else int(time_to_wait * _NANOSECONDS)
        simulation.spin_once({process}, limit)
    finally:
        subscription.destroy()
    return received.done(), received.result()
