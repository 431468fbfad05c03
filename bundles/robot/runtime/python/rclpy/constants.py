"""As `rclpy.constants`."""

from eventchain_ros2 import refusals
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND

S_TO_NS = NANOSECONDS_PER_SECOND

__all__ = ["S_TO_NS"]
__getattr__ = refusals.of_module(__name__)
