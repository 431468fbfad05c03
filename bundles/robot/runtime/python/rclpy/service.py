"""As `rclpy.service`."""

from eventchain_ros2 import refusals
from eventchain_ros2.services import Service

__all__ = ["Service"]
__getattr__ = refusals.of_module(__name__)
