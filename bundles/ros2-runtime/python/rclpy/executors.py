"""As `rclpy.executors`, without executors: the lock-step host runs the nodes."""

from __future__ import annotations

from typing import Any

from eventchain_ros2.context import NO_EXECUTOR


class ExternalShutdownException(Exception):  # noqa: N818 - rclpy's name
    """The context was shut down from outside, for example by a signal."""


class Executor:
    """Refused."""

    def __init__(self, *_: Any, **__: Any) -> None:
        raise NotImplementedError(NO_EXECUTOR)


class SingleThreadedExecutor(Executor):
    """Refused."""


class MultiThreadedExecutor(Executor):
    """Refused."""


__all__ = ["Executor", "ExternalShutdownException", "MultiThreadedExecutor", "SingleThreadedExecutor"]
