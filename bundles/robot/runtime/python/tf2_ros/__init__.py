"""The part of ROS 2's `tf2_ros` that Eventchain's runtime supports; implemented in `eventchain_ros2`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transform_nodes import (
    Buffer,
    StaticTransformBroadcaster,
    TransformBroadcaster,
    TransformListener,
    TransformRegistration,
    TypeException,
)
from eventchain_ros2.transforms import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

__all__ = [
    "Buffer",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "StaticTransformBroadcaster",
    "TimeoutException",
    "TransformBroadcaster",
    "TransformException",
    "TransformListener",
    "TransformRegistration",
    "TypeException",
]
__getattr__ = refusals.of_module(__name__)
