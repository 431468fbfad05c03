import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool


class Looks(Node):
    def __init__(self):
        super().__init__("looks")
        self.create_subscription(Bool, "arrived", print, 1)


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(Looks())
