"""As `rclpy.node`."""

from eventchain_ros2 import refusals
from eventchain_ros2.node import Node
from eventchain_ros2.parameters import Parameter

__all__ = ["Node", "Parameter"]
__getattr__ = refusals.of_module(__name__)
