"""As `rclpy.subscription`."""

from eventchain_ros2 import refusals
from eventchain_ros2.endpoints import Subscription

__all__ = ["Subscription"]
__getattr__ = refusals.of_module(__name__)
