"""As `rclpy.publisher`."""

from eventchain_ros2.endpoints import Publisher

__all__ = ["Publisher"]
