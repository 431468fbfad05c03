"""The simulation in which this process's nodes live (`rclpy.init`, `ok`, `shutdown`)."""

from __future__ import annotations

from eventchain_ros2.simulation import Simulation

NO_EXECUTOR = (
    "Eventchain's runtime has simulated time only, in which the lock-step host runs the nodes: "
    "source ROS 2 to let a node spin by itself"
)


class NotInitializedException(Exception):  # noqa: N818 - rclpy's name
    """A node is made outside `rclpy.init` and `rclpy.shutdown`."""

    def __init__(self) -> None:
        super().__init__("rclpy.init() has not been called")


class _Context:
    simulation: Simulation | None = None
    initialized = False  # by user code


_context = _Context()


def enter(simulation: Simulation) -> None:
    """Make the following nodes live in this simulation; user code may still call `init` once."""
    _context.simulation = simulation
    _context.initialized = False


def init() -> None:
    """Start a simulation, unless the host has done that."""
    if _context.initialized and ok():
        raise RuntimeError("Context.init() must only be called once")
    if not ok():
        _context.simulation = Simulation()
    _context.initialized = True


def ok() -> bool:
    """Whether nodes can be made and run."""
    return _context.simulation is not None and _context.simulation.running


def current() -> Simulation:
    """The simulation that runs.

    Raises:
        NotInitializedException: none does.

    """
    if _context.simulation is None or not ok():
        raise NotInitializedException
    return _context.simulation


def shutdown() -> None:
    """End the simulation: no callback runs any more."""
    current().running = False
