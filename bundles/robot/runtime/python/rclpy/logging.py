"""As `rclpy.logging`."""

from eventchain_ros2 import context as _context
from eventchain_ros2 import refusals
from eventchain_ros2.logger import Logger, LoggingSeverity


def get_logger(name: str) -> Logger:
    """Return a logger without a node."""
    simulation = _context.current()
    return Logger(name, lambda: simulation.now)


__all__ = ["Logger", "LoggingSeverity", "get_logger"]
__getattr__ = refusals.of_module(__name__)
