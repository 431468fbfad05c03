import rclpy
from rclpy.node import Node


class Silent(Node):
    """Has no constructor of its own."""

    def listen(self):
        self.create_publisher(Float32, "~/answer", 10)
        self.create_subscription(Float32, "question", self.on_question, 10)

    def on_question(self, question):
        pass


def main():
    rclpy.init()
    rclpy.spin(Silent("listener"))


from std_msgs.msg import Float32  # noqa: E402
