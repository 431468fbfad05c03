"""A node whose topics are parameters that are not known."""

import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import Float32


class Odd(Node):
    def __init__(self):
        super().__init__("odd")
        self.declare_parameter("unset", Parameter.Type.STRING)
        self.declare_parameter("fixed", "fixed", ignore_override=True)
        self.declare_parameter("number", "text")
        self.declare_parameter("open", "open")
        self.create_subscription(Float32, self.get_parameter("unset").value, self.on_value, 10)
        self.create_subscription(Float32, self.get_parameter("fixed").value, self.on_value, 10)
        self.create_subscription(Float32, self.get_parameter("number").value, self.on_value, 10)
        self.create_subscription(Float32, self.get_parameter("open").value, self.on_value, 10)
        self.create_subscription(Float32, self.get_parameter("nowhere").value, self.on_value, 10)
        self.output = self.create_publisher(Float32, "odd", 10)

    def on_value(self, message):
        self.output.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Odd())
