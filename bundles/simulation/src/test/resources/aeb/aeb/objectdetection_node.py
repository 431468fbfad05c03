"""A node in the shape of the generated ones: it connects a component with its topics."""

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from sensor_msgs.msg import PointCloud2

from aeb.components.ObjectDetection import ObjectDetection


class ObjectDetection_node(Node):
    """Executes ObjectDetection at 20 Hz."""

    def __init__(self):
        super().__init__("ObjectDetection_node")
        self.component = ObjectDetection()
        self.stamp_sec = None
        self.stamp_nanosec = None
        self.height = None
        self.width = None
        self.point_step = None
        self.row_step = None
        self.data = None
        self.create_subscription(PointCloud2, "/carla/ego_vehicle/lidar", self.on_input_0, qos_profile_sensor_data)
        self.output_0 = self.create_publisher(LaserScan, "/scan", qos_profile_sensor_data)
        self.timer = self.create_timer(1.0 / 20.0, self.execute)

    def on_input_0(self, message):
        """Keep the newest message of /carla/ego_vehicle/lidar."""
        self.stamp_sec = message.header.stamp.sec
        self.stamp_nanosec = message.header.stamp.nanosec
        self.height = message.height
        self.width = message.width
        self.point_step = message.point_step
        self.row_step = message.row_step
        self.data = message.data

    def execute(self):
        """Run the component on the newest inputs and publish what it returns."""
        if self.stamp_sec is None:
            return
        output = self.component.execute(
            stamp_sec=self.stamp_sec,
            stamp_nanosec=self.stamp_nanosec,
            height=self.height,
            width=self.width,
            point_step=self.point_step,
            row_step=self.row_step,
            data=self.data,
        )
        message = LaserScan()
        message.header.stamp.sec = output["scan_stamp_sec"]
        message.header.stamp.nanosec = output["scan_stamp_nanosec"]
        message.header.frame_id = output["frame_id"]
        message.angle_min = output["angle_min"]
        message.angle_max = output["angle_max"]
        message.angle_increment = output["angle_increment"]
        message.scan_time = output["scan_time"]
        message.range_min = output["range_min"]
        message.range_max = output["range_max"]
        message.ranges = output["ranges"]
        self.output_0.publish(message)


def main(args=None):
    """Run the node until it is shut down."""
    rclpy.init(args=args)
    rclpy.spin(ObjectDetection_node())
    rclpy.shutdown()
