"""As `rclpy.client`."""

from eventchain_ros2 import refusals
from eventchain_ros2.services import Client

__all__ = ["Client"]
__getattr__ = refusals.of_module(__name__)
