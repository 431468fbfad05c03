"""A node in the shape of the generated ones: it connects a component with its topics."""

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from carla_msgs.msg import CarlaEgoVehicleStatus
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float32

from aeb.components.TTC_Calculation import TTC_Calculation


class TTC_Calculation_node(Node):
    """Executes TTC_Calculation at 20 Hz."""

    def __init__(self):
        super().__init__("TTC_Calculation_node")
        self.component = TTC_Calculation()
        self.scan_stamp_sec = None
        self.scan_stamp_nanosec = None
        self.ranges = None
        self.velocity = None
        self.create_subscription(LaserScan, "/scan", self.on_input_0, qos_profile_sensor_data)
        self.create_subscription(CarlaEgoVehicleStatus, "/carla/ego_vehicle/vehicle_status", self.on_input_1, 10)
        self.output_0 = self.create_publisher(Float32, "/aeb/time_to_collision", 10)
        self.timer = self.create_timer(1.0 / 20.0, self.execute)

    def on_input_0(self, message):
        """Keep the newest message of /scan."""
        self.scan_stamp_sec = message.header.stamp.sec
        self.scan_stamp_nanosec = message.header.stamp.nanosec
        self.ranges = message.ranges

    def on_input_1(self, message):
        """Keep the newest message of /carla/ego_vehicle/vehicle_status."""
        self.velocity = message.velocity

    def execute(self):
        """Run the component on the newest inputs and publish what it returns."""
        if self.scan_stamp_sec is None or self.velocity is None:
            return
        output = self.component.execute(
            scan_stamp_sec=self.scan_stamp_sec,
            scan_stamp_nanosec=self.scan_stamp_nanosec,
            ranges=self.ranges,
            velocity=self.velocity,
        )
        message = Float32()
        message.data = output["time_to_collision"]
        self.output_0.publish(message)


def main(args=None):
    """Run the node until it is shut down."""
    rclpy.init(args=args)
    rclpy.spin(TTC_Calculation_node())
    rclpy.shutdown()
