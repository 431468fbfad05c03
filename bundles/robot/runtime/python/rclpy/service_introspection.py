"""As `rclpy.service_introspection`; only `OFF` is supported."""

from eventchain_ros2 import refusals
from eventchain_ros2.services import ServiceIntrospectionState

__all__ = ["ServiceIntrospectionState"]
__getattr__ = refusals.of_module(__name__)
