"""Makes the node in a function of a function."""

import rclpy
from rclpy.node import Node

LIMIT = print


class Brake(Node):
    def __init__(self, limit, gain):
        super().__init__("brake")
        self.limit = limit
        self.gain = gain


def main():
    LIMIT = 1.6

    def start(gain=LIMIT):
        rclpy.init()
        rclpy.spin(Brake(LIMIT, gain))

    start()
