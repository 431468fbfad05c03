"""As `tf2_ros.transform_listener`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import TransformListener

__all__ = ["TransformListener"]
__getattr__ = refusals.of_module(__name__)
