"""Publishes the messages of /PREFIX_out on /PREFIX_back, from the callback.

Arguments: PREFIX, type, history (depth, all) and reliability (reliable, best_effort).
"""

import contextlib
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float32

PREFIX, TYPE, HISTORY, RELIABILITY = sys.argv[1:5]
MESSAGE = {"Float32": Float32, "LaserScan": LaserScan}[TYPE]


class Callback(Node):
    """The node."""

    def __init__(self):
        super().__init__(f"callback_{PREFIX}")
        profile = QoSProfile(
            depth=10,
            history=HistoryPolicy.KEEP_ALL if HISTORY == "all" else HistoryPolicy.KEEP_LAST,
            reliability=ReliabilityPolicy.RELIABLE if RELIABILITY == "reliable" else ReliabilityPolicy.BEST_EFFORT,
        )
        self.publisher = self.create_publisher(MESSAGE, f"/{PREFIX}_back", profile)
        self.create_subscription(MESSAGE, f"/{PREFIX}_out", self.hear, profile)

    def hear(self, message):
        """Answer."""
        self.publisher.publish(message)


rclpy.init()
with contextlib.suppress(ExternalShutdownException):
    rclpy.spin(Callback())
