"""What the runtime makes of names of topics: reads them as a JSON array, writes the full ones, null for those refused."""

import json
import sys

import rclpy
from rclpy.exceptions import InvalidTopicNameException
from rclpy.node import Node


def resolved(node, topic):
    """The full name of a topic, or nothing if there cannot be one."""
    try:
        return node.resolve_topic_name(topic)
    except InvalidTopicNameException:
        return None


rclpy.init()
NODE = Node(sys.argv[1])
json.dump([resolved(NODE, topic) for topic in json.load(sys.stdin)], sys.stdout)
