"""The simulation of this process's nodes (`rclpy.init`, `ok`, `shutdown`)."""

from __future__ import annotations

from collections.abc import Callable

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


class _Context:
    def __init__(self) -> None:
        self.simulation: Simulation | None = None
        self.initialized = False  # called by user code
        self.start: Callable[[int | None], Simulation] = lambda _: Simulation()


_context = _Context()


def enter(simulation: Simulation) -> None:
    """Use this simulation for new nodes; user code may still call `init` once."""
    _use(simulation)
    _context.initialized = False


def _use(simulation: Simulation) -> None:
    _context.simulation = simulation
    Clock.without_node = simulation.clock_of_callback


def start_with(start: Callable[[int | None], Simulation]) -> None:
    """Make `init` start this instead of a simulation; the argument is the domain passed to `init`, if any."""
    _context.start = start


def init(domain_id: int | None = None) -> None:
    """Start a simulation, or its replacement, unless the host has started one."""
    if _context.initialized and ok():
        raise RuntimeError("Context.init() must only be called once")
    if not ok():
        _use(_context.start(domain_id))
    _context.initialized = True


def ok() -> bool:
    """Return whether nodes can be created and run."""
    return _context.simulation is not None and _context.simulation.running


def is_simulated() -> bool:
    """Return whether time is simulated, so that waiting is impossible."""
    return _context.simulation is None or _context.simulation.is_simulated


def current() -> Simulation:
    """Return the running simulation.

    Raises:
        NotInitializedException: none is running.

    """
    if _context.simulation is None or not ok():
        raise NotInitializedException
    return _context.simulation


def shutdown() -> None:
    """End the simulation: no further callback runs.

    Raises:
        NotInitializedException: it was never started.
        RuntimeError: it has already ended, for example by a signal (rclpy raises its subclass RCLError).

    """
    if _context.simulation is not None and not ok():
        raise RuntimeError("failed to shut down: the context is already shut down")
    current().stop()
