"""As `rclpy.time`."""

from eventchain_ros2 import refusals
from eventchain_ros2.clock import Time

__all__ = ["Time"]
__getattr__ = refusals.of_module(__name__)
