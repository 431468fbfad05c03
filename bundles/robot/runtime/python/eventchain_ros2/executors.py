"""Executors in simulated time: the part of `rclpy.executors` for sequential callbacks."""

from __future__ import annotations

from typing import Any

from eventchain_ros2 import context
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND
from eventchain_ros2.node import Node


class ExternalShutdownException(Exception):  # noqa: N818 - rclpy's name
    """The context was shut down from outside, for example by a signal."""


class Executor:
    """Runs the callbacks of its nodes sequentially. In simulated time no timeout takes wall time."""

    def __init__(self, *, context: Any = None) -> None:
        self._nodes: list[Node] = []
        self._is_shutdown = False

    def add_node(self, node: Node) -> bool:
        """Run the callbacks of this node, too; return whether it is new."""
        if node in self._nodes:
            return False
        self._nodes.append(node)
        return True

    def remove_node(self, node: Node) -> None:
        """Stop running the callbacks of this node."""
        if node in self._nodes:
            self._nodes.remove(node)

    def get_nodes(self) -> list[Node]:
        """Return the nodes of this executor."""
        return list(self._nodes)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Let time pass until a callback has run, or for this number of seconds.

        If several nodes receive the same sample, or have waiting samples, all of their callbacks run.

        Raises:
            ExternalShutdownException: the context or this executor was shut down.
            RuntimeError: there is no limit, and no further event.

        """
        if self._is_shutdown or not context.ok():
            raise ExternalShutdownException
        wait = None if timeout_sec is None or timeout_sec < 0 else int(timeout_sec * NANOSECONDS_PER_SECOND)
        ran = context.current().spin_once({node._eventchain_process for node in self._nodes}, wait)
        if not ran and not context.ok():
            raise ExternalShutdownException

    def spin(self) -> None:
        """Run callbacks until one of them stops this.

        Raises:
            ExternalShutdownException: something else has stopped it, such as a signal.
            NotImplementedError: time is simulated, and would run without end.

        """
        if context.is_simulated():
            raise NotImplementedError(context.NO_EXECUTOR)
        while context.ok() and not self._is_shutdown:
            self.spin_once()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop running callbacks."""
        self._is_shutdown = True
        self._nodes.clear()
        return True


class SingleThreadedExecutor(Executor):
    """One callback at a time."""


class MultiThreadedExecutor(Executor):
    """One callback at a time, too: in simulated time threads have no benefit."""

    def __init__(self, num_threads: int | None = None, *, context: Any = None) -> None:
        super().__init__(context=context)
