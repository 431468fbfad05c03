"""Queries of the graph, in simulated time."""

from __future__ import annotations

import rclpy
from eventchain_ros2.simulation import Simulation
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data


def talk_and_listen() -> tuple[Node, Node]:
    from std_msgs.msg import Bool, Float32

    talker, listener = Node("talker", namespace="/front"), Node("listener")
    talker.create_publisher(Float32, "number", 10)
    listener.create_subscription(Float32, "/front/number", print, qos_profile_sensor_data)
    listener.create_subscription(Bool, "/switch", print, 10)
    return talker, listener


def test_topics_and_their_ends_are_found(simulation: Simulation) -> None:
    talker, listener = talk_and_listen()
    number = "/front/number", ["std_msgs/msg/Float32"]
    assert listener.get_topic_names_and_types() == [number, ("/switch", ["std_msgs/msg/Bool"])]
    assert (talker.count_publishers("number"), listener.count_publishers("number")) == (1, 0)
    assert (talker.count_subscribers("number"), listener.count_subscribers("/switch")) == (1, 1)
    (info,) = listener.get_subscriptions_info_by_topic("/front/number")
    assert (info.node_name, info.node_namespace, info.topic_type) == ("listener", "/", "std_msgs/msg/Float32")
    assert info.qos_profile == qos_profile_sensor_data
    (info,) = listener.get_publishers_info_by_topic("/front/number")
    assert (info.node_name, info.node_namespace, len(info.endpoint_gid)) == ("talker", "/front", 16)
    ends = [
        *listener.get_publishers_info_by_topic("/front/number"),
        *listener.get_subscriptions_info_by_topic("/switch"),
    ]
    assert ends[0].endpoint_gid != ends[1].endpoint_gid
    assert listener.get_publisher_names_and_types_by_node("talker", "/front") == [number]
    assert listener.get_publisher_names_and_types_by_node("talker", "/") == []
    assert [name for name, _ in listener.get_subscriber_names_and_types_by_node("listener", "/")] == [
        "/front/number",
        "/switch",
    ]


def test_nodes_are_found_and_waited_for(simulation: Simulation) -> None:
    talker, _ = talk_and_listen()
    assert talker.get_node_names() == ["talker", "listener"]
    assert talker.get_node_names_and_namespaces() == [("talker", "/front"), ("listener", "/")]
    assert talker.get_fully_qualified_node_names() == ["/front/talker", "/listener"]
    assert talker.wait_for_node("/listener", 1.0)
    assert simulation.now == 0
    assert not talker.wait_for_node("/nobody", 0.25)
    assert simulation.now == 250_000_000


def test_a_destroyed_end_is_not_there_any_more(simulation: Simulation) -> None:
    talker, listener = talk_and_listen()
    (subscription, _) = listener.subscriptions
    assert subscription.get_publisher_count() == 1
    talker.destroy_node()
    assert (subscription.get_publisher_count(), listener.count_publishers("/front/number")) == (0, 0)
    rclpy.shutdown()
