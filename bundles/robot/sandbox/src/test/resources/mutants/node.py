"""A node as it is: its endpoints, what only tells, and what it does not reach have no mutants."""

import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import Bool, Float32

LIMIT = 2.6


def risk(distance, speed):
    return distance / max(speed, 0.1)


def unused(value):
    return value + 1


class Other(Node):
    def __init__(self):
        super().__init__("other")
        self.create_timer(0.5, lambda: None)
        self.count = 3


class Example(Node):
    def __init__(self):
        super().__init__("example")
        self.speed = 0.0
        self.scale = self.declare_parameter("scale", 2.0).value
        self.output = self.create_publisher(Bool, "/warning", QoSProfile(depth=10))
        self.create_subscription(Float32, "/speed", self.on_speed, 10)
        self.create_subscription(Float32, "/gap", lambda gap: self.keep(gap.data > 20.0), 10)
        self.create_timer(0.05, self.on_timer)

    def on_speed(self, message):
        self.speed = message.data * 3.6
        self.get_logger().info(f"speed {self.speed + 1}")

    def keep(self, far):
        self.far = far

    def on_timer(self):
        warns = risk(20.0, self.speed) < LIMIT
        self.output.publish(Bool(data=warns))


def main():
    rclpy.init()
    for _ in range(3):
        rclpy.spin(Example())


if __name__ == "__main__":
    main()
