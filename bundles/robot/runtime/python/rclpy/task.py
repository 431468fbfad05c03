"""As `rclpy.task`."""

from eventchain_ros2 import refusals
from eventchain_ros2.tasks import Future, Task

__all__ = ["Future", "Task"]
__getattr__ = refusals.of_module(__name__)
