import os

import helper
import rclpy
from message_filters import Subscriber, TimeSynchronizer
from rclpy.node import Node
from sensor_msgs.msg import Range
from std_msgs.msg import Bool, Empty, Float32

if os.environ.get("ROS_DISTRO") == "humble":
    from geometry_msgs.msg import Twist as Command
else:
    from geometry_msgs.msg import TwistStamped as Command


class Arrival(Node):
    """Publishes that something came: of its messages it reads nothing."""

    def __init__(self):
        super().__init__("arrival")
        self.publisher = self.create_publisher(Bool, "arrived", 1)
        self.create_subscription(Float32, "anything", self.on_anything, 1)
        self.create_subscription(Empty, "nothing", self.on_anything, 1)
        self.create_publisher(Command, "command", 1)
        joined = [Subscriber(self, Range, name) for name in ("front", "rear")]
        self.both = TimeSynchronizer(joined, 10)

    def on_anything(self, _message):
        self.publisher.publish(Bool(data=helper.TRUE))


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(Arrival())
