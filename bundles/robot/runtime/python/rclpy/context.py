"""As `rclpy.context`; all contexts of a process share the life of its nodes."""

from eventchain_ros2 import refusals
from eventchain_ros2.context import Context

__all__ = ["Context"]
__getattr__ = refusals.of_module(__name__)
