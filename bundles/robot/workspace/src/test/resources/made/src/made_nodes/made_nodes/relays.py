import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Relay(Node):
    """Scales what it reads."""

    def __init__(self, name, source, *, target="target", period=0.1, gain=1.0):
        super().__init__(name, namespace="made")
        self.gain = gain
        self.number = 0.0
        self.output = self.create_publisher(Float32, f"{name}/{target}", 10)
        self.create_subscription(Float32, source, self.on_number, 10)
        self.create_timer(period, self.on_timer)

    def on_number(self, number):
        self.number = number.data

    def on_timer(self):
        self.output.publish(Float32(data=self.gain * self.number))


class Doubling(Relay):
    def __init__(self, source):
        super().__init__("doubling", source, gain=2.0)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(make("source"))


def make(source):
    return Doubling(source)
