"""As `rclpy.timer`."""

from eventchain_ros2 import refusals
from eventchain_ros2.endpoints import Rate, Timer

__all__ = ["Rate", "Timer"]
__getattr__ = refusals.of_module(__name__)
