"""As `rclpy.clock`."""

from eventchain_ros2.clock import Clock, ClockType

__all__ = ["Clock", "ClockType"]
