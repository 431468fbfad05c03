"""As `rclpy.guard_condition`."""

from eventchain_ros2 import refusals
from eventchain_ros2.endpoints import GuardCondition

__all__ = ["GuardCondition"]
__getattr__ = refusals.of_module(__name__)
