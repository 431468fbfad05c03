"""Makes the node with a parameter of a lambda, not with the constant of the file."""

import rclpy
from rclpy.node import Node

LIMIT = 1.6
MAKE = lambda LIMIT: Brake(LIMIT)


class Brake(Node):
    def __init__(self, limit):
        super().__init__("brake")
        self.limit = limit


def main():
    rclpy.init()
    rclpy.spin(MAKE(2.5))
