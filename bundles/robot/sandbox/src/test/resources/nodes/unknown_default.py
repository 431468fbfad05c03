import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, limits=()):
        super().__init__("brake")


def main():
    rclpy.init()
    limits = []
    limits.append(1.5)
    rclpy.spin(Brake(limits))
