"""The part of ROS 2's `sensor_msgs_py` that Eventchain's runtime supports; implemented in `eventchain_ros2`."""

from eventchain_ros2 import refusals

__getattr__ = refusals.of_module(__name__)
