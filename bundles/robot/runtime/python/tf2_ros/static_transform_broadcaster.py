"""As `tf2_ros.static_transform_broadcaster`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import StaticTransformBroadcaster

__all__ = ["StaticTransformBroadcaster"]
__getattr__ = refusals.of_module(__name__)
