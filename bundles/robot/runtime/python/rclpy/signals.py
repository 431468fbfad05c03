"""As `rclpy.signals`; the options are accepted, and all signals are handled."""

from enum import IntEnum

from eventchain_ros2 import refusals


class SignalHandlerOptions(IntEnum):
    """Set of signals that are handled."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


__all__ = ["SignalHandlerOptions"]
__getattr__ = refusals.of_module(__name__)
