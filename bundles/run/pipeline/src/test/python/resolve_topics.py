"""Resolves topic names with the runtime: reads a JSON array of names, writes the full names, null for rejected ones."""

import json
import sys

import rclpy
from rclpy.exceptions import InvalidTopicNameException
from rclpy.node import Node


def resolved(node, topic):
    """Returns the full name of a topic, or None if the name is illegal."""
    try:
        return node.resolve_topic_name(topic)
    except InvalidTopicNameException:
        return None


rclpy.init()
NODE = Node(sys.argv[1])
json.dump([resolved(NODE, topic) for topic in json.load(sys.stdin)], sys.stdout)
