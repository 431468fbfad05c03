"""Executors in simulated time: the part of `rclpy.executors` for sequential callbacks."""

from __future__ import annotations

from threading import get_ident
from typing import TYPE_CHECKING, Any, NoReturn

from eventchain_ros2 import context
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND
from eventchain_ros2.node import Node

if TYPE_CHECKING:
    from eventchain_ros2.tasks import Future, Task


class ExternalShutdownException(Exception):  # noqa: N818 - rclpy's name
    """The context was shut down from outside, for example by a signal."""


class ShutdownException(Exception):  # noqa: N818 - rclpy's name
    """The executor was shut down."""


class TimeoutException(Exception):  # noqa: N818 - rclpy's name
    """The time for a callback is over."""


class Executor:
    """Runs the callbacks of its nodes sequentially. In simulated time no timeout takes wall time."""

    def __init__(self, *, context: Any = None) -> None:
        self._nodes: list[Node] = []
        self._is_shutdown = False

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()

    @property
    def context(self) -> context.Context:
        """Return the context of its nodes."""
        return context.default

    def add_node(self, node: Node) -> bool:
        """Run the callbacks of this node, too; return whether it is new."""
        if node in self._nodes:
            return False
        self._nodes.append(node)
        node.executor = self
        return True

    def remove_node(self, node: Node) -> None:
        """Stop running the callbacks of this node."""
        if node in self._nodes:
            self._nodes.remove(node)
            node.executor = None

    def get_nodes(self) -> list[Node]:
        """Return the nodes of this executor."""
        return list(self._nodes)

    @property
    def is_shutdown(self) -> bool:
        """Return whether it was shut down."""
        return self._is_shutdown

    def wake(self) -> None:
        """End the current `spin_once` of another thread, or the next; in simulated time there is none."""
        if self._nodes and context.ok() and not context.is_simulated():
            context.current().call(self._nodes[0]._eventchain_process, lambda: None)

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Run a function or coroutine as a further callback of the executor's first node; return its future.

        Raises:
            RuntimeError: there is no node whose callback it could be.

        """
        if not self._nodes:
            raise RuntimeError("a task is a callback of a node: add one to the executor before")
        from eventchain_ros2 import tasks

        return tasks.run(context.current(), self._nodes[0]._eventchain_process, callback, *args, **kwargs)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Let time pass until a callback has run, or for this number of seconds.

        If several nodes receive the same sample, or have waiting samples, all of their callbacks run.

        Raises:
            ExternalShutdownException: the context or this executor was shut down.
            RuntimeError: there is no limit, and no further event; or a callback wants to wait in simulated time.

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

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Run callbacks until a future is done, or for this number of seconds.

        Raises:
            ExternalShutdownException: the context or this executor was shut down.
            RuntimeError: there is no limit, and no further event; or a callback wants to wait in simulated time.

        """
        unlimited = timeout_sec is None or timeout_sec < 0
        thread = get_ident()
        future.add_done_callback(lambda _: None if get_ident() == thread else self.wake())
        end = None if unlimited else context.current().elapsed() + int(timeout_sec * NANOSECONDS_PER_SECOND)  # type: ignore[operator]
        while not future.done():
            left = None if end is None else end - context.current().elapsed()
            if left is not None and left < 0:
                return
            self.spin_once_until_future_complete(future, None if left is None else left / NANOSECONDS_PER_SECOND)
            if left == 0:
                return

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Run one callback, unless the future is done; see `spin_once`."""
        if not future.done():
            self.spin_once(timeout_sec)

    def wait_for_ready_callbacks(self, *_: object, **__: object) -> NoReturn:
        """Raise an error: executors of one's own cannot choose among callbacks here."""
        raise NotImplementedError("executors that choose callbacks themselves are not part of Eventchain's runtime")

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop running callbacks."""
        self._is_shutdown = True
        for node in list(self._nodes):
            self.remove_node(node)
        return True


class SingleThreadedExecutor(Executor):
    """One callback at a time."""


class MultiThreadedExecutor(Executor):
    """One callback at a time, too: in simulated time threads have no benefit."""

    def __init__(self, num_threads: int | None = None, *, context: Any = None) -> None:
        super().__init__(context=context)
