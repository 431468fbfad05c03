"""As `rclpy.parameter`."""

from eventchain_ros2.parameters import Parameter, ParameterType

__all__ = ["Parameter", "ParameterType"]
