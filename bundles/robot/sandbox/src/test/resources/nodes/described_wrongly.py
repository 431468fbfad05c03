from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit, gain=1.0):
        super().__init__("brake")
