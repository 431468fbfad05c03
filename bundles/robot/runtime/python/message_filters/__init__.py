"""The part of ROS 2's `message_filters` that Eventchain's runtime supports; implemented in `eventchain_ros2`."""

from eventchain_ros2 import refusals
from eventchain_ros2.filters import (
    ApproximateTimeSynchronizer,
    Cache,
    SimpleFilter,
    Subscriber,
    TimeSynchronizer,
)

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]
__getattr__ = refusals.of_module(__name__)
