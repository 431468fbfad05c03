"""As `rclpy.subscription`."""

from eventchain_ros2.endpoints import Subscription

__all__ = ["Subscription"]
