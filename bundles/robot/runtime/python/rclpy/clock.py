"""As `rclpy.clock`."""

from eventchain_ros2 import refusals
from eventchain_ros2.clock import Clock, ClockType, ROSClock

__all__ = ["Clock", "ClockType", "ROSClock"]
__getattr__ = refusals.of_module(__name__)
