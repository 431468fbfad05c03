"""Time to collision with what the radar sees."""

import rclpy
from demo_msgs.msg import RadarTarget, Threat
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data

from .topics import TARGET

RATE_HZ = 50
NO_COLLISION = 1000.0


class Tracker(Node):
    """Turns each target of the radar into a time to collision."""

    def __init__(self):
        super().__init__("tracker")
        self.declare_parameter("slowest", 0.1)
        self.latest = None
        self.create_subscription(RadarTarget, TARGET, self.on_target, qos_profile_sensor_data)
        self.publisher = self.create_publisher(Threat, "threat", 10)
        self.create_timer(1.0 / RATE_HZ, self.on_timer)

    def on_target(self, target):
        self.latest = target

    def on_timer(self):
        if self.latest is None:
            return
        closing = -self.latest.range_rate if self.latest.valid else 0.0
        threat = Threat(closing_speed=closing)
        slow = closing <= self.get_parameter("slowest").value
        threat.time_to_collision = NO_COLLISION if slow else min(self.latest.range / closing, NO_COLLISION)
        self.publisher.publish(threat)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Tracker())
