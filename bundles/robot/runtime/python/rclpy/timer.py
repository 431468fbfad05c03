"""As `rclpy.timer`."""

from eventchain_ros2.endpoints import Timer

__all__ = ["Timer"]
