import sys

import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, side):
        super().__init__("brake")


def main():
    rclpy.init()
    side = "left"
    match sys.argv:
        case [_, side]:
            pass
    rclpy.spin(Brake(side))
