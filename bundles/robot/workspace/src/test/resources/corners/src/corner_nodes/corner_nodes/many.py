import rclpy
import rclpy.qos
from message_filters import Subscriber
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSPresetProfiles, QoSProfile, QoSReliabilityPolicy
from std_msgs.msg import Bool, Float32, String
from unknown_msgs.msg import Unknown

from .elsewhere import Base, latched

NAME = "many"
COUNT = 3
COUNT += 1


class Many(Node):
    """Every way to say what an endpoint is."""

    TOPIC = "class_constant"

    def __init__(self):
        super().__init__(NAME, namespace="own")
        self.prefix = "prefix"
        self.changed = "one"
        self.changed = "two"
        local = self.prefix + "/" + NAME
        self.create_publisher(Bool, local, 1)
        self.create_publisher(Bool, self.TOPIC, QoSPresetProfiles.SENSOR_DATA.value)
        self.create_publisher(Bool, Many.TOPIC + "_again", rclpy.qos.qos_profile_system_default)
        self.create_publisher(msg_type=Bool, topic="~/private", qos_profile=latched)
        self.create_publisher(
            Float32,
            f"/absolute/{self.prefix}",
            QoSProfile(
                depth=5,
                history=HistoryPolicy.KEEP_ALL,
                reliability=QoSReliabilityPolicy.BEST_EFFORT,
                durability=DurabilityPolicy.VOLATILE,
                deadline=Duration(seconds=1, nanoseconds=500_000_000),
            ),
        )
        self.filtered = Subscriber(self, String, "filtered")
        self.create_subscription(String, "read_by_lambda", lambda message: print(message.data), 10)
        self.create_timer(0.1, self.tick)
        self.create_timer(2, self.tick)
        # From here on, something is not said.
        self.create_publisher(Bool, self.changed, 1)
        self.create_publisher(Bool, f"count_{COUNT}", 1)
        self.create_publisher(Bool, self.get_parameter("topic").get_parameter_value().string_value, 1)
        self.create_publisher(Unknown, "unknown_type", 1)
        self.create_publisher(self.prefix, "no_type", 1)
        self.create_publisher(Bool, "not a topic", 1)
        profile = QoSProfile(depth=1)
        profile.durability = DurabilityPolicy.TRANSIENT_LOCAL
        self.create_publisher(Bool, "changed_qos", profile)
        self.create_timer(self.period(), self.tick)
        for name in ("left", "right"):
            self.create_publisher(Bool, name, 1)
        if self.prefix:
            self.create_publisher(Bool, "conditional", 1)
        self.other.create_publisher(Bool, "of_another", 1)
        self.create_service(object, "service", self.tick)

    def tick(self):
        pass


class Odd(Base):
    def __init__(self):
        super().__init__()
        self.create_publisher(Bool, "odd", 1)


class Alone(Node):
    def __init__(self):
        super().__init__("alone")


def main():
    rclpy.init()
    rclpy.spin(Many())


def helper():
    print("no node")
