"""As `rclpy.duration`."""

from eventchain_ros2 import refusals
from eventchain_ros2.clock import Duration

__all__ = ["Duration"]
__getattr__ = refusals.of_module(__name__)
