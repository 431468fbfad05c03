import sys

import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit):
        super().__init__("brake")


def main():
    rclpy.init()
    limit = float(sys.argv[1])
    rclpy.spin(Brake(limit))
