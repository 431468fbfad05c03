"""The part of ROS 2's `rclpy` API that Eventchain's runtime supports; implemented in `eventchain_ros2`.

This package is on `sys.path` only within hosts of nodes and in tests that request it. Nodes that use it run unchanged
under ROS 2.
"""

from __future__ import annotations

from collections.abc import Iterator as _Iterator
from contextlib import contextmanager as _contextmanager
from typing import Any, NoReturn

from eventchain_ros2 import context as _context
from eventchain_ros2.executors import Executor as _Executor
from eventchain_ros2.node import Node as _Node
from eventchain_ros2.parameters import Parameter as Parameter


class InitContextManager:
    """The result of `init`: as a context manager, it stops all callbacks at the end of its block."""

    def __enter__(self) -> InitContextManager:
        """Return this; nodes can be created since `init`."""
        return self

    def __exit__(self, *_: object) -> None:
        """Stop all callbacks, if they are still running."""
        try_shutdown()


def init(
    *, args: list[str] | None = None, context: Any = None, domain_id: int | None = None, **_: Any
) -> InitContextManager:
    """Allow the creation of nodes, to the end of the block if the result is used in a `with`."""
    _context.init(domain_id)
    return InitContextManager()


def ok(*, context: Any = None) -> bool:
    """Return whether nodes can be created and run."""
    return _context.ok()


def shutdown(*, context: Any = None, uninstall_handlers: bool | None = None) -> None:
    """Stop all callbacks."""
    _context.shutdown()


def try_shutdown(*, context: Any = None, uninstall_handlers: bool | None = None) -> None:
    """Stop all callbacks, if they are running."""
    if _context.ok():
        _context.shutdown()


def create_node(node_name: str, **options: Any) -> _Node:
    """Create a node without a class of its own."""
    return _Node(node_name, **options)


def spin(node: _Node, executor: _Executor | None = None) -> None:
    """Run the callbacks of the node until one of them stops this; in simulated time a host does it."""
    with _running(node, executor) as runner:
        runner.spin()


def spin_once(node: _Node, *, executor: _Executor | None = None, timeout_sec: float | None = None) -> None:
    """Let time pass until a callback of the node has run, or for this number of seconds."""
    with _running(node, executor) as runner:
        runner.spin_once(timeout_sec)


@_contextmanager
def _running(node: _Node, executor: _Executor | None) -> _Iterator[_Executor]:
    runner = executor or _Executor()
    added = runner.add_node(node)
    try:
        yield runner
    finally:
        if added:
            runner.remove_node(node)


def spin_until_future_complete(
    node: _Node, future: Any, executor: Any = None, timeout_sec: float | None = None
) -> NoReturn:
    """Raise an error: futures, services and actions are not part of this runtime."""
    raise NotImplementedError("futures are not part of Eventchain's runtime")
