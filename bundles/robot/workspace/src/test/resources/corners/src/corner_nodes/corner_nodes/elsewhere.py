from foreign_package import Base
from rclpy.qos import DurabilityPolicy, QoSProfile

latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
__all__ = ["Base", "latched"]
