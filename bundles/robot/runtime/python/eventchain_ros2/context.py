"""The simulation in which this process's nodes live (`rclpy.init`, `ok`, `shutdown`)."""

from __future__ import annotations

from collections.abc import Callable

from eventchain_ros2.simulation import Simulation

NO_EXECUTOR = (
    "in simulated time a host runs the nodes: let a node spin by itself with "
    "`python -m eventchain_ros2 NODE.py`, or with ROS 2 sourced"
)


class NotInitializedException(Exception):  # noqa: N818 - rclpy's name
    """A node is made outside `rclpy.init` and `rclpy.shutdown`."""

    def __init__(self) -> None:
        super().__init__("rclpy.init() has not been called")


class _Context:
    def __init__(self) -> None:
        self.simulation: Simulation | None = None
        self.initialized = False  # by user code
        self.start: Callable[[int | None], Simulation] = lambda _: Simulation()


_context = _Context()


def enter(simulation: Simulation) -> None:
    """Make the following nodes live in this simulation; user code may still call `init` once."""
    _context.simulation = simulation
    _context.initialized = False


def start_with(start: Callable[[int | None], Simulation]) -> None:
    """Let `init` start this instead of a simulation; the argument is the domain that it asks for, if it does."""
    _context.start = start


def init(domain_id: int | None = None) -> None:
    """Start a simulation, or what was chosen instead, unless the host has done that."""
    if _context.initialized and ok():
        raise RuntimeError("Context.init() must only be called once")
    if not ok():
        _context.simulation = _context.start(domain_id)
    _context.initialized = True


def ok() -> bool:
    """Whether nodes can be made and run."""
    return _context.simulation is not None and _context.simulation.running


def is_simulated() -> bool:
    """Whether time is simulated, so that nobody may wait for it."""
    return _context.simulation is None or _context.simulation.is_simulated


def current() -> Simulation:
    """The simulation that runs.

    Raises:
        NotInitializedException: none does.

    """
    if _context.simulation is None or not ok():
        raise NotInitializedException
    return _context.simulation


def shutdown() -> None:
    """End the simulation: no callback runs any more.

    Raises:
        NotInitializedException: it was never started.
        RuntimeError: it has ended already, for example by a signal (rclpy raises its RCLError, which is one).

    """
    if _context.simulation is not None and not ok():
        raise RuntimeError("failed to shut down: the context is already shut down")
    current().stop()
