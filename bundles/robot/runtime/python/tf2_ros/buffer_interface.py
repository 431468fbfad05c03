"""As `tf2_ros.buffer_interface`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import TransformRegistration, TypeException

__all__ = ["TransformRegistration", "TypeException"]
__getattr__ = refusals.of_module(__name__)
