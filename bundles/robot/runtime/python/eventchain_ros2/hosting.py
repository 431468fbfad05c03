"""Common part of the hosts of nodes: nodes and their components are created, run, interrupted, and removed.

A host is a program for `confined.py`, which starts it and, on its behalf, the processes of components. Only hosts put
the folder of this package in front of `sys.path`, so that `import rclpy` finds this runtime; everywhere else a sourced
ROS 2 has precedence.
"""

from __future__ import annotations

import ast
import copy
import functools
import gc
import importlib
import json
import platform
import signal
import sys
from abc import ABC, abstractmethod
from collections.abc import Callable
from pathlib import Path
from typing import Any

import node_construction
from component_client import ComponentError, Limits

from eventchain_ros2 import catalog, context, faults, message_objects, output_faults
from eventchain_ros2.channel import Channel, Kind
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND, Duration
from eventchain_ros2.components import Components, Configuration, Environment
from eventchain_ros2.endpoints import Timer
from eventchain_ros2.failures import HostError, StepTimeout, describe
from eventchain_ros2.faults import NEVER
from eventchain_ros2.messages import Messages
from eventchain_ros2.node import Node
from eventchain_ros2.node_sources import RUNTIME, NodeSources, text_of
from eventchain_ros2.processes import Launched
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from eventchain_ros2.simulation import Process, Simulation
from eventchain_ros2.value_latency import Answer

OBSERVES = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.BEST_EFFORT)
"""Quality of service of a subscription that observes a topic: whatever is offered."""

_UNLIMITED = 1e9  # s


def world_profile(entry: dict[str, Any], unstated: QoSProfile) -> QoSProfile:
    """Return the quality of service of the world on a topic of the configuration."""
    stated = entry.get("qos")
    if stated is None:
        return unstated
    return QoSProfile(
        history=unstated.history,
        depth=unstated.depth,
        reliability=ReliabilityPolicy.BEST_EFFORT if stated["best_effort"] else ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if stated["transient"] else DurabilityPolicy.VOLATILE,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC if stated["manual"] else LivelinessPolicy.AUTOMATIC,
        deadline=Duration(nanoseconds=stated["deadline"]),
        liveliness_lease_duration=Duration(nanoseconds=stated["lease"]),
    )


class HostedNodes:
    """The nodes of one configuration, from start to end."""

    def __init__(self, configuration: dict[str, Any], simulation: Simulation | None = None) -> None:
        self.configuration = configuration
        self.step_limit = float(configuration.get("step_limit_s", 0))  # of processor time; 0: none
        self.folders: list[str] = list(configuration.get("path", []))
        self.simulation = simulation or Simulation()
        self.processes: list[Process] = []
        self._messages = Messages(catalog.read(map(Path, configuration.get("messages", []))))
        self._components = self._make_components()
        self._losses: dict[str, dict[str, Any]] = {}  # names of failed nodes
        fault = configuration.get("fault")
        self.simulation.fault = output_faults.of(fault, self._messages.get) or faults.of(fault)
        if "fault" in configuration:
            self.simulation.survives = self._lose
        self._objects: list[object] = []  # keeps the nodes alive

    def _make_components(self) -> Components:
        configuration = self.configuration
        environment = Environment(
            path=[RUNTIME, *self.folders],
            sources=self.folders,
            messages=list(configuration.get("messages", [])),
            limits=Limits(self.step_limit or _UNLIMITED, float(configuration.get("wall_limit_s", _UNLIMITED))),
            objects=message_objects.of(self._messages, importing=False),
        )
        known = [Configuration.of(node["component"]) for node in configuration.get("nodes", []) if node["component"]]
        clock = (lambda: self.simulation.now) if configuration.get("answers") else None
        return Components(known, environment, self.simulation.spend, clock)

    def prepare(self, sources: NodeSources) -> None:
        """Make message types, components and nodes importable."""
        self._messages.install()
        self._components.install()
        sources.serve(self.folders, self.configuration.get("replaced", {}))
        context.enter(self.simulation)

    def message_type(self, name: str, topic: str) -> type:
        """Return the class of a message type such as `std_msgs/msg/Float32`, for a topic."""
        package, *kind, short_name = name.split("/")
        try:
            return self._messages.get("/".join((package, *(kind or ["msg"]), short_name)))
        except KeyError as missing:
            raise HostError("message.unknown", f"topic {topic}: no message type {missing.args[0]}") from None

    def start_nodes(self) -> None:
        """Import the modules and create the nodes."""
        for node in self.configuration.get("nodes", []):
            self._start_node(node)

    def _start_node(self, configuration: dict[str, Any]) -> None:
        name = configuration["name"]
        times = (round(configuration.get(key, 0) * 1e6) for key in ("execution_time_ms", "phase_ms"))
        process = self.simulation.add_process(name, *times)
        as_it_is = configuration.get("node") is not None
        process.launched = Launched(**(configuration["node"] if as_it_is else {}))
        self.processes.append(process)
        with self.simulation.starting(process):
            module = importlib.import_module(configuration["module"])
            node_class = getattr(module, configuration["class"], None)
            if not callable(node_class):
                raise HostError(
                    "node.class.missing", f"there is no class {configuration['class']}", module.__file__ or ""
                )
            if not _is_rclpy(node_class):
                node = self._start_plain_node(node_class, process)
            elif as_it_is:
                node = _constructed(node_class, configuration["class"], module.__file__, process.launched)
            else:
                node = node_class()
        self._objects.append(node)

    def _start_plain_node(self, node_class: Any, process: Process) -> Any:
        """Create a node that is a class around DDS readers and writers, and execute it periodically."""
        from eventchain_ros2.dds import DomainParticipant  # nodes of rclpy start without it

        node = node_class(DomainParticipant())
        for clock in ("now", "wall_clock"):  # clocks for the age of its inputs, and for the stamps of its messages
            if hasattr(node_class, clock):
                setattr(node, clock, lambda: self.simulation.clock(process))
        period = int(float(node.period) * NANOSECONDS_PER_SECOND)
        if period <= 0:
            raise ValueError(f"a node needs a period of at least a nanosecond, not {node.period} s")
        self._objects.append(Timer(self.simulation, process, period, node.execute))
        return node

    def activations(self) -> list[dict[str, Any]]:
        """Return the activations of each node, and the effects of a fault on it."""
        return [
            {"name": process.name, "activations": process.activations, **self._affected(process)}
            for process in self.processes
        ]

    def answers(self) -> dict[str, list[Answer]]:
        """Return which outputs of each node's component answered which inputs, if its calls are recorded."""
        if not self.configuration.get("answers"):
            return {}
        nodes = [node for node in self.configuration.get("nodes", []) if node["component"]]
        return {node["name"]: self._components.answers(node["component"]["module"]) for node in nodes}

    def _affected(self, process: Process) -> dict[str, Any]:
        if "fault" not in self.configuration:
            return {}
        fault = self.simulation.fault
        count, first = (0, NEVER) if fault is None else fault.affected.get(process.name, (0, NEVER))
        return {"affected": count, "affected_first": first, "loss": self._losses.get(process.name)}

    def _lose(self, process: Process, error: BaseException) -> bool:
        """Remove a node whose code fails, as its process would end; in a run with a fault the others continue."""
        if not isinstance(error, Exception | ComponentError | SystemExit):
            return False
        self._losses[process.name] = {"time": self.simulation.now, **describe(error, process.name, self.folders)}
        return True

    def warnings(self) -> list[dict[str, Any]]:
        """Return the connections that were not made."""
        return [warning._asdict() for warning in self.simulation.warnings]

    def end(self) -> None:
        """End the components."""
        self._components.end()


def _is_rclpy(node_class: Any) -> bool:
    """Return whether a node creates its own timers, as with rclpy; a node on plain DDS states its period."""
    return not hasattr(node_class, "period") or (isinstance(node_class, type) and issubclass(node_class, Node))


def _constructed(node_class: Any, name: str, file: str | None, launched: Launched) -> Any:
    """Make a node that is there as it is with the arguments of its description, or those that its file gives it."""
    if launched.arguments is not None:
        return node_class(**launched.arguments)
    made = _construction(text_of(file), name) if file else None
    return node_class() if made is None else node_class(*copy.deepcopy(made.positional), **copy.deepcopy(made.named))


@functools.lru_cache
def _construction(source: bytes, class_name: str) -> node_construction.Construction | None:
    """Return how a file makes a node; None if it does not say that, which was found before anything is simulated."""
    try:
        return node_construction.read(ast.parse(source), class_name)
    except (node_construction.UnknownConstructionError, SyntaxError, ValueError):
        return None


class Host(ABC):
    """Answers frames until the input ends.

    Args:
        channel: channel of the frames and answers.

    """

    def __init__(self, channel: Channel) -> None:
        self.channel = channel
        self._sources = NodeSources()
        gc.freeze()  # all present objects live until the end: exclude them from garbage collection
        sys.dont_write_bytecode = True  # a changed file of the same second and size would go unnoticed
        signal.signal(signal.SIGPROF, self._interrupt)

    @property
    @abstractmethod
    def nodes(self) -> HostedNodes | None:
        """Return the running nodes."""

    @abstractmethod
    def answer(self, kind: int, payload: memoryview) -> None:
        """Answer a frame."""

    def next_frame(self) -> tuple[int, memoryview] | None:
        """Wait for a frame; return None at the end."""
        return self.channel.read()

    def run(self) -> int:
        """Serve; return the exit code, 1 after a FAILED frame."""
        try:
            while (frame := self.next_frame()) is not None:
                self.answer(*frame)
                signal.setitimer(signal.ITIMER_PROF, 0)
        except KeyboardInterrupt:
            return 130
        except BaseException as error:  # user code may raise anything, even SystemExit
            signal.setitimer(signal.ITIMER_PROF, 0)
            folders = self.nodes.folders if self.nodes else []
            current = self.nodes.simulation.current if self.nodes else None
            self.channel.write_json(Kind.FAILED, describe(error, current.name if current else "", folders))
            return 1
        return 0

    def start(self, start: Callable[[NodeSources], None], ready: Callable[[], dict[str, Any]]) -> None:
        """Start nodes, with modules that no scenario has executed before, and report that they are ready."""
        self.limit()
        self._sources.unload()
        start(self._sources)
        gc.collect()
        self.channel.write_json(Kind.READY, {"python": platform.python_version(), **ready()})

    def limit(self) -> None:
        """Interrupt nodes that exceed the scenario's time for one answer; components have separate limits."""
        if self.nodes is not None and self.nodes.step_limit:
            signal.setitimer(signal.ITIMER_PROF, self.nodes.step_limit)

    def _interrupt(self, *_: object) -> None:
        limit = self.nodes.step_limit if self.nodes else 0.0
        raise StepTimeout(f"it used more than {limit:g} s of processor time")


def unexpected(kind: int) -> HostError:
    """Return the error for an unexpected frame."""
    return HostError("protocol.frame", f"a frame of kind {kind} is not expected here")


def parse(payload: memoryview) -> Any:
    """Parse the JSON of a frame."""
    return json.loads(bytes(payload))
