from rclpy.node import Node


class Brake(Node):
    def __init__(self, limit, *, gain, topic="/request"):
        super().__init__("brake")
