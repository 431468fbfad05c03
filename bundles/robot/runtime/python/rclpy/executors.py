"""As `rclpy.executors`; `spin` is refused, because simulated time would run without end."""

from eventchain_ros2 import refusals
from eventchain_ros2.executors import (
    Executor,
    ExternalShutdownException,
    MultiThreadedExecutor,
    ShutdownException,
    SingleThreadedExecutor,
    TimeoutException,
)

__all__ = [
    "Executor",
    "ExternalShutdownException",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
]
__getattr__ = refusals.of_module(__name__)
