"""Guard between navigation and the motors of a mobile robot: it slows down and stops before obstacles."""

import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan


class SpeedGuard(Node):
    """Limits the commanded speed by the distance to what is ahead."""

    def __init__(self):
        super().__init__("speed_guard")
        self.declare_parameter("scan_topic", "scan")
        self.declare_parameter("rate", 10.0)
        self.declare_parameters(
            "zones", [("stop", 0.5), ("slow", 1.5), ("slow_speed", 0.3), ("half_angle", 0.6)]
        )
        self.stop = self.get_parameter("zones.stop").value
        self.slow = self.get_parameter("zones.slow").value
        self.slow_speed = self.get_parameter("zones.slow_speed").value
        self.half_angle = self.get_parameter("zones.half_angle").value
        self.nearest = math.inf
        self.wanted = Twist()
        scan_topic = self.get_parameter("scan_topic").get_parameter_value().string_value
        self.create_subscription(LaserScan, scan_topic, self.on_scan, qos_profile_sensor_data)
        self.create_subscription(Twist, "cmd_vel_nav", self.on_wanted, 10)
        self.commands = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_timer(1.0 / self.get_parameter("rate").value, self.on_timer)

    def on_scan(self, scan):
        ahead = [
            distance
            for index, distance in enumerate(scan.ranges)
            if abs(scan.angle_min + index * scan.angle_increment) <= self.half_angle
            and scan.range_min <= distance <= scan.range_max
        ]
        self.nearest = min(ahead, default=math.inf)

    def on_wanted(self, wanted):
        self.wanted = wanted

    def on_timer(self):
        command = Twist()
        command.linear.x = min(self.wanted.linear.x, self.limit())
        command.angular.z = self.wanted.angular.z
        self.commands.publish(command)

    def limit(self):
        if self.nearest <= self.stop:
            return 0.0
        return self.slow_speed if self.nearest <= self.slow else math.inf


def main():
    rclpy.init()
    rclpy.spin(SpeedGuard())
