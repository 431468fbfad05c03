"""As `tf2_ros.transform_broadcaster`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import TransformBroadcaster

__all__ = ["TransformBroadcaster"]
__getattr__ = refusals.of_module(__name__)
