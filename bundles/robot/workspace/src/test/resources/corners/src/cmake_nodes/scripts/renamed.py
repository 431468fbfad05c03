import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32


class Renamed(Node):
    def __init__(self):
        super().__init__("renamed")
        self.publisher = self.create_publisher(Float32, "anything", 1)
        self.create_subscription(Bool, "arrived", self.on_arrival, 1)

    def on_arrival(self, message):
        self.publisher.publish(Float32(data=float(message.data)))


def start():
    rclpy.spin(Renamed())


rclpy.init()
start()
