"""As `rclpy.wait_for_message`."""

from eventchain_ros2 import refusals
from eventchain_ros2.messages_once import wait_for_message

__all__ = ["wait_for_message"]
__getattr__ = refusals.of_module(__name__)
