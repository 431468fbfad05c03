"""The part of ROS 2's `rclpy` API that Eventchain's runtime supports; implemented in `eventchain_ros2`.

This package is on `sys.path` only within hosts of nodes and in tests that request it. Nodes that use it run unchanged
under ROS 2.
"""

from __future__ import annotations

import importlib as _importlib
from collections.abc import Iterator as _Iterator
from contextlib import contextmanager as _contextmanager
from typing import Any

from eventchain_ros2 import context as _context
from eventchain_ros2 import refusals as _refusals
from eventchain_ros2.executors import Executor as _Executor
from eventchain_ros2.node import Node as _Node
from eventchain_ros2.parameters import Parameter as Parameter

_MODULES = {
    "callback_groups",
    "client",
    "clock",
    "constants",
    "context",
    "duration",
    "exceptions",
    "executors",
    "guard_condition",
    "logging",
    "node",
    "parameter",
    "publisher",
    "qos",
    "serialization",
    "service",
    "service_introspection",
    "signals",
    "subscription",
    "task",
    "time",
    "timer",
    "utilities",
    "wait_for_message",
}
"""Modules that `import rclpy` alone gives access to, when they are used."""
_refuse = _refusals.of_module(__name__)
_executors: list[_Executor] = []  # the global one


class InitContextManager:
    """The result of `init`: as a context manager, it stops all callbacks at the end of its block."""

    def __init__(self, context: _context.Context) -> None:
        self.context = context

    def __enter__(self) -> InitContextManager:
        """Return this; nodes can be created since `init`."""
        return self

    def __exit__(self, *_: object) -> None:
        """Stop all callbacks, if they are still running."""
        self.context.try_shutdown()


def init(
    args: list[str] | None = None,
    *,
    context: _context.Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: object = None,
) -> InitContextManager:
    """Allow the creation of nodes, to the end of the block if the result is used in a `with`."""
    chosen = context or _context.default
    chosen.init(args, domain_id=domain_id)
    return InitContextManager(chosen)


def ok(*, context: _context.Context | None = None) -> bool:
    """Return whether nodes can be created and run."""
    return (context or _context.default).ok()


def shutdown(*, context: _context.Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Stop all callbacks."""
    (context or _context.default).shutdown()


def try_shutdown(*, context: _context.Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Stop all callbacks, if they are running."""
    (context or _context.default).try_shutdown()


def get_default_context(*, shutting_down: bool = False) -> _context.Context:
    """Return the context of everything that names none."""
    return _context.default


def create_node(node_name: str, **options: Any) -> _Node:
    """Create a node without a class of its own."""
    return _Node(node_name, **options)


def get_global_executor() -> _Executor:
    """Return an executor for all users of this function."""
    if not _executors or _executors[0].is_shutdown:
        _executors[:] = [_Executor()]
    return _executors[0]


def spin(node: _Node, executor: _Executor | None = None) -> None:
    """Run the callbacks of the node until one of them stops this; in simulated time a host does it."""
    with _running(node, executor) as runner:
        runner.spin()


def spin_once(node: _Node, *, executor: _Executor | None = None, timeout_sec: float | None = None) -> None:
    """Let time pass until a callback of the node has run, or for this number of seconds."""
    with _running(node, executor) as runner:
        runner.spin_once(timeout_sec)


def spin_until_future_complete(
    node: _Node, future: Any, executor: _Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run the callbacks of the node until the future is done, or for this number of seconds."""
    with _running(node, executor) as runner:
        runner.spin_until_future_complete(future, timeout_sec)


@_contextmanager
def _running(node: _Node, executor: _Executor | None) -> _Iterator[_Executor]:
    runner = executor or _Executor()
    before = node.executor
    added = runner.add_node(node)
    try:
        yield runner
    finally:
        if added:
            runner.remove_node(node)
            node.executor = before


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return _importlib.import_module(f"rclpy.{name}")
    if name in ("Future", "Task"):
        return getattr(_importlib.import_module("rclpy.task"), name)
    return _refuse(name)
