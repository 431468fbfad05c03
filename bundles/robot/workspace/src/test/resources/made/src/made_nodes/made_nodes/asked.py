import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Asked(Node):
    """Of which the command line says what it is made with."""

    def __init__(self, limit, topic, *others):
        super().__init__("asked")
        self.limit = limit
        self.output = self.create_publisher(Float32, topic, 10)
        self.create_subscription(Float32, "above", self.on_above, 10)

    def on_above(self, above):
        self.output.publish(Float32(data=min(self.limit, above.data)))


def main():
    rclpy.init()
    rclpy.spin(Asked(float(sys.argv[1]), "below"))
