"""Fields that are used: of kept, handed on, copied and escaping messages."""

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan, Range
from std_msgs.msg import Float32


class Kept(Node):
    def __init__(self):
        super().__init__("kept")
        self.last = None
        self.create_subscription(Range, "kept", self.on_kept, 10)
        self.create_subscription(LaserScan, "handed", self.on_handed, 10)
        self.create_subscription(Float32, "escapes", self.on_escapes, 10)
        self.output = self.create_publisher(Twist, "output", 10)
        self.create_timer(1 / 30, self.on_timer)

    def on_kept(self, message):
        self.last = message

    def on_handed(self, scan):
        self.use(scan)

    def use(self, scan):
        self.nearest = min(scan.ranges) - scan.range_min
        self.stamp = scan.header.stamp

    def on_escapes(self, message):
        print(message)

    def on_timer(self):
        if self.last is not None and self.last.range > self.last.min_range:
            command = Twist()
            command.linear.x = 1.0
            self.output.publish(command)


def main():
    rclpy.init()
    node = make()
    rclpy.spin(node)


def make():
    return Kept()
