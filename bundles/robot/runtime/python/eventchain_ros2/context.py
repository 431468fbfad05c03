"""The simulation of this process's nodes (`rclpy.init`, `ok`, `shutdown`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from eventchain_ros2.clock import Clock
from eventchain_ros2.simulation import Simulation

NO_EXECUTOR = (
    "in simulated time a host runs the nodes: let a node spin by itself with "
    "`python -m eventchain_ros2 NODE.py`, or with ROS 2 sourced"
)


class NotInitializedException(Exception):  # noqa: N818 - rclpy's name
    """A node is created before `rclpy.init` or after `rclpy.shutdown`."""

    def __init__(self) -> None:
        super().__init__("rclpy.init() has not been called")


class _World:
    def __init__(self) -> None:
        self.simulation: Simulation | None = None
        self.start: Callable[[int | None], Simulation] = lambda _: Simulation()


_world = _World()


class Context:
    """The life of the nodes of this process, as in `rclpy.context`. All contexts of a process share one."""

    def __init__(self) -> None:
        self._started: Simulation | None = None  # the simulation that user code has initialised
        self._domain: int | None = None
        self._at_end: list[Callable[[], object]] = []

    def __enter__(self) -> Context:
        return self

    def __exit__(self, *_: object) -> None:
        self.try_shutdown()

    def init(self, args: Any = None, *, initialize_logging: bool = True, domain_id: int | None = None) -> None:
        """Start a simulation, or its replacement, unless the host has started one."""
        if self._started is not None and self._started is _world.simulation and self.ok():
            raise RuntimeError("Context.init() must only be called once")
        if not self.ok():
            _use(_world.start(domain_id))
        self._started, self._domain = _world.simulation, domain_id

    def ok(self) -> bool:
        """Return whether nodes can be created and run."""
        return ok()

    def get_domain_id(self) -> int:
        """Return the number of the domain that was asked for, 0 if none was."""
        return self._domain or 0

    def on_shutdown(self, callback: Callable[[], object]) -> None:
        """Call this at the shutdown."""
        self._at_end.append(callback)

    def forget(self) -> None:
        """Forget what was to be called at the shutdown, by nodes of an earlier simulation."""
        self._at_end.clear()

    def shutdown(self) -> None:
        """End the simulation: no further callback runs.

        Raises:
            NotInitializedException: it was never started.
            RuntimeError: it has already ended, for example by a signal (rclpy raises its subclass RCLError).

        """
        if _world.simulation is not None and not self.ok():
            raise RuntimeError("failed to shut down: the context is already shut down")
        current().stop()
        callbacks, self._at_end = self._at_end, []
        for callback in callbacks:
            callback()

    def try_shutdown(self) -> None:
        """End the simulation, if it is running."""
        if self.ok():
            self.shutdown()


default = Context()
"""The context of everything that names none."""


def enter(simulation: Simulation) -> None:
    """Use this simulation for new nodes; user code may still call `init` once."""
    _use(simulation)
    default.forget()


def _use(simulation: Simulation) -> None:
    _world.simulation = simulation
    Clock.without_node = simulation.clock_of_callback
    Clock.sleep = simulation.sleep


def start_with(start: Callable[[int | None], Simulation]) -> None:
    """Make `init` start this instead of a simulation; the argument is the domain passed to `init`, if any."""
    _world.start = start


def ok() -> bool:
    """Return whether nodes can be created and run."""
    return _world.simulation is not None and _world.simulation.running


def is_simulated() -> bool:
    """Return whether time is simulated, so that waiting is impossible."""
    return _world.simulation is None or _world.simulation.is_simulated


def current() -> Simulation:
    """Return the running simulation.

    Raises:
        NotInitializedException: none is running.

    """
    if _world.simulation is None or not ok():
        raise NotInitializedException
    return _world.simulation
