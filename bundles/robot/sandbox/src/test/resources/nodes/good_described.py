import sys

import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit, topic="/request"):
        super().__init__("brake")


def main():
    rclpy.init()
    rclpy.spin(Brake(float(sys.argv[1])))
