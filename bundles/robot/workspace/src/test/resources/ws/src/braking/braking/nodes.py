"""What is done about a threat."""

import rclpy
from demo_msgs.msg import BrakeRequest, Threat
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool

THREAT = "/aeb" + "/threat"


class ThreatNode(Node):
    def __init__(self, name):
        super().__init__(name)
        self.create_subscription(Threat, THREAT, self.on_threat, 10)


class Brake(ThreatNode):
    """Brakes fully below a time to collision, until the threat is over."""

    full_brake_ttc = 1.6

    def __init__(self):
        super().__init__("brake")
        self.braking = False
        qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)
        self.request = self.create_publisher(BrakeRequest, "request", qos)

    def on_threat(self, msg):
        near = msg.time_to_collision < self.full_brake_ttc
        self.braking = near or (self.braking and msg.closing_speed > 0.0)
        self.request.publish(BrakeRequest(active=self.braking, acceleration=-9.0 if self.braking else 0.0))


class Warning(ThreatNode):
    """Warns the driver."""

    def __init__(self):
        super().__init__("warning")
        self.output = self.create_publisher(Bool, self.declare_parameter("topic", "/warning").value, 10)

    def on_threat(self, msg):
        self.output.publish(Bool(data=msg.time_to_collision < 2.6))


def main():
    rclpy.init()
    rclpy.spin(Brake())


def warn():
    rclpy.init()
    rclpy.spin(Warning())
