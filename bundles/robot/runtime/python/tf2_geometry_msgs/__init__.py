"""The part of ROS 2's `tf2_geometry_msgs` that Eventchain's runtime supports; implemented in `eventchain_ros2`."""

from eventchain_ros2 import refusals
from eventchain_ros2.transformed import (
    do_transform_point,
    do_transform_pose,
    do_transform_pose_stamped,
    do_transform_vector3,
    register,
)

register()

__all__ = ["do_transform_point", "do_transform_pose", "do_transform_pose_stamped", "do_transform_vector3"]
__getattr__ = refusals.of_module(__name__)
