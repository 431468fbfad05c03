import rclpy
from rclpy.node import Node

LIMIT = 1.5
SIDES = ["left", "right"]


class Base(Node):
    def __init__(self, name, limit, *, gain, sides):
        super().__init__(name)


class Brake(Base):
    pass


def make(limit=2 * LIMIT):
    gain = -0.5
    return Brake("front_" + "brake", limit, gain=gain, sides=SIDES)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(make())
