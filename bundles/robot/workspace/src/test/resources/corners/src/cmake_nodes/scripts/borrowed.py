import rclpy
from std_msgs.msg import Bool


class Arm:
    def __init__(self):
        self.node = rclpy.create_node("arm")
        self.publisher = self.node.create_publisher(Bool, "moves", 1)


def main():
    rclpy.init()
    node = rclpy.create_node("teleop")
    node.create_publisher(Bool, "key", 1)
    rclpy.spin(Arm().node)


if __name__ == "__main__":
    main()
