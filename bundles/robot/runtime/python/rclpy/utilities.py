"""As `rclpy.utilities`."""

from __future__ import annotations

import sys

from eventchain_ros2 import refusals

from rclpy import get_default_context, ok, shutdown, try_shutdown


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """Return the arguments without those between `--ros-args` and `--`."""
    kept: list[str] = []
    is_ros = False
    for argument in sys.argv if args is None else args:
        if argument == "--ros-args":
            is_ros = True
        elif is_ros and argument == "--":
            is_ros = False
        elif not is_ros:
            kept.append(argument)
    return kept


__all__ = ["get_default_context", "ok", "remove_ros_args", "shutdown", "try_shutdown"]
__getattr__ = refusals.of_module(__name__)
