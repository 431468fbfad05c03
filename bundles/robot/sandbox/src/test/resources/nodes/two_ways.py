import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self, name):
        super().__init__(name)


def front():
    rclpy.init()
    rclpy.spin(Brake("front"))


def rear():
    rclpy.init()
    rclpy.spin(Brake("rear"))
