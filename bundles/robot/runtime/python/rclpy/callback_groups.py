"""As `rclpy.callback_groups`; each process runs one callback at a time, in any group."""

from eventchain_ros2 import refusals
from eventchain_ros2.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]
__getattr__ = refusals.of_module(__name__)
