import rclpy.node as ros


class TtcNode(ros.Node):
    pass
