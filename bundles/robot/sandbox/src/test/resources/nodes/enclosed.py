"""Makes the node with a parameter of the function around, not with the constant of the file."""

import rclpy
from rclpy.node import Node

LIMIT = 1.6


class Brake(Node):
    def __init__(self, limit):
        super().__init__("brake")
        self.limit = limit


def main(LIMIT):
    def start():
        rclpy.init()
        rclpy.spin(Brake(LIMIT))

    return start
