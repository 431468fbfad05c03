"""As `rclpy.time`."""

from eventchain_ros2.clock import Time

__all__ = ["Time"]
