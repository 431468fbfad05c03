import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node("ttc")
    rclpy.spin(node)
