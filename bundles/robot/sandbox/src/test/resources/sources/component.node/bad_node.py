import rclpy
from rclpy.node import Node


class TTC(Node):
    def __init__(self):
        super().__init__("ttc")

    def execute(self, distance, speed):
        return {"ttc": distance}


def main():
    rclpy.init()
