"""As `rclpy.duration`."""

from eventchain_ros2.clock import Duration

__all__ = ["Duration"]
