"""As `rclpy.publisher`."""

from eventchain_ros2 import refusals
from eventchain_ros2.endpoints import Publisher

__all__ = ["Publisher"]
__getattr__ = refusals.of_module(__name__)
