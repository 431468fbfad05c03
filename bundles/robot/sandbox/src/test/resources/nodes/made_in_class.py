import sys

import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit=1.5):
        super().__init__("brake")


class Program:
    def run(self):
        rclpy.init()
        rclpy.spin(Brake(float(sys.argv[1])))


def main():
    Program().run()
