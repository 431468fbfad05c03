import rclpy
from std_msgs.msg import Bool


def test_arrival():
    rclpy.init()
    rclpy.create_node("test").create_publisher(Bool, "arrived", 1)
