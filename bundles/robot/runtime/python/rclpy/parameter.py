"""As `rclpy.parameter`."""

from eventchain_ros2 import refusals
from eventchain_ros2.parameters import Parameter, ParameterType, parameter_value_to_python

__all__ = ["Parameter", "ParameterType", "parameter_value_to_python"]
__getattr__ = refusals.of_module(__name__)
