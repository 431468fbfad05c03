"""As `tf2_ros.buffer`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import Buffer

__all__ = ["Buffer"]
__getattr__ = refusals.of_module(__name__)
