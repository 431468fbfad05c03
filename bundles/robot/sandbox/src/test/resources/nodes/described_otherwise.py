import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit, gain=1.0):
        super().__init__("brake")


def main():
    rclpy.init()
    rclpy.spin(Brake(1.5, gain=2.0))
