"""Nodes whose topics, rates and quality of service are parameters."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Filter(Node):
    def __init__(self):
        super().__init__("filter")
        self.declare_parameter("input", "raw")
        self.declare_parameter("rate", 20.0)
        self.declare_parameters("output", [("topic", "filtered"), ("depth", 10)])
        source = self.get_parameter("input").get_parameter_value().string_value
        rate = self.get_parameter("rate")
        self.latest = Float32()
        self.create_subscription(Float32, source, self.on_raw, 10)
        self.output = self.create_publisher(
            Float32, self.get_parameter("output.topic").value, self.get_parameter("output.depth").value
        )
        self.create_timer(1.0 / rate.value, self.on_timer)

    def on_raw(self, message):
        self.latest = message

    def on_timer(self):
        self.output.publish(Float32(data=self.latest.data))


class Limiter(Node):
    def __init__(self):
        super().__init__("limiter")
        self.limit = self.declare_parameter("limit", 1.0).value
        topic = self.declare_parameter(name="topic", value="filtered").value
        self.output = self.create_publisher(Float32, "limited", 10)
        self.create_subscription(Float32, topic, self.on_value, 10)

    def on_value(self, message):
        self.output.publish(Float32(data=min(message.data, self.limit)))


def main():
    rclpy.init()
    rclpy.spin(Filter())


def limiter():
    rclpy.init()
    rclpy.spin(Limiter())
