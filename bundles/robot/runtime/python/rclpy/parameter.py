"""As `rclpy.parameter`."""

from eventchain_ros2 import refusals
from eventchain_ros2.parameters import Parameter, ParameterType

__all__ = ["Parameter", "ParameterType"]
__getattr__ = refusals.of_module(__name__)
