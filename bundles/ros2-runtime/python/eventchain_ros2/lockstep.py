"""The lock-step host: runs nodes in simulated time, driven over standard input and output.

It is a program for `confined.py`, which starts it and, on its behalf, the processes of components. The protocol is
described in this bundle's README. This host, and nothing else, puts the folder of this package in front of `sys.path`,
so that `import rclpy` finds ours; everywhere else a sourced ROS 2 wins.
"""

from __future__ import annotations

import gc
import importlib
import json
import os
import platform
import signal
import struct
import sys
from enum import IntEnum
from pathlib import Path
from typing import Any, BinaryIO

from component_client import Limits

from eventchain_ros2 import context, message_objects
from eventchain_ros2.clock import NANOSECONDS_PER_SECOND, Duration
from eventchain_ros2.components import Components, Configuration, Environment
from eventchain_ros2.dds import DomainParticipant
from eventchain_ros2.endpoints import Publisher, Subscription, Timer
from eventchain_ros2.failures import HostError, StepTimeout, describe
from eventchain_ros2.messages import Messages
from eventchain_ros2.node import Node
from eventchain_ros2.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from eventchain_ros2.simulation import LimitError, Process, Sample, Simulation

SOURCES = str(Path(__file__).resolve().parents[1])

# The world offers everything a node may request, and requests nothing that a node may not offer.
_WORLD_OFFERS = QoSProfile(
    depth=1,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    deadline=Duration(nanoseconds=1),
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    liveliness_lease_duration=Duration(nanoseconds=1),
)
_WORLD_REQUESTS = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.BEST_EFFORT)

_UNLIMITED = 1e9  # s

LONGEST_FRAME = 1 << 25
"""Bytes."""
MOST_COMMANDS = 10_000
"""Samples for the world in one step."""

_FRAME = struct.Struct("<IB")
_STEP = struct.Struct("<qH")
_STEP_SAMPLE = struct.Struct("<HI")
_COUNT = struct.Struct("<H")
_STEPPED_SAMPLE = struct.Struct("<qHI")


class Kind(IntEnum):
    """Kinds of frames."""

    CONFIGURE = 1
    READY = 2
    STEP = 3
    STEPPED = 4
    FINISH = 5
    FINISHED = 6
    FAILED = 7
    RESET = 8


class Channel:
    """Reads and writes frames."""

    def __init__(self, source: BinaryIO, target: BinaryIO) -> None:
        self._source = source
        self._target = target

    def read(self) -> tuple[int, memoryview] | None:
        """The next frame, or None at the end."""
        head = self._source.read(_FRAME.size)
        if not head:
            return None
        if len(head) == _FRAME.size:
            length, kind = _FRAME.unpack(head)
            payload = self._source.read(length - 1)
            if len(payload) == length - 1:
                return kind, memoryview(payload)
        raise HostError("protocol.frame", "the input ended within a frame")

    def write(self, kind: Kind, *payload: bytes | bytearray | memoryview) -> None:
        """Write a frame."""
        length = 1 + sum(map(len, payload))
        if length > LONGEST_FRAME:
            raise LimitError(f"what is to be said of the scenario is longer than {LONGEST_FRAME >> 20} MiB")
        self._target.write(b"".join((_FRAME.pack(length, kind), *payload)))
        self._target.flush()

    def write_json(self, kind: Kind, value: object) -> None:
        """Write a frame of JSON."""
        self.write(kind, json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode(errors="replace"))


class _Outlet(Subscription):
    """The world's subscription: keeps the samples until the step ends."""

    def __init__(self, index: int, target: list[bytes | bytearray | memoryview], *arguments: Any) -> None:
        super().__init__(*arguments)
        self._index = index
        self._target = target

    def receive(self, sample: Sample) -> None:
        if len(self._target) >= 2 * MOST_COMMANDS:
            raise LimitError(f"more than {MOST_COMMANDS:,} commands were published in one step")
        self._target += (_STEPPED_SAMPLE.pack(sample.time, self._index, len(sample.data)), sample.data)


class Scenario:
    """The nodes of one configuration, from its start to its end."""

    def __init__(self, configuration: dict[str, Any]) -> None:
        self._configuration = configuration
        self.step_limit = float(configuration.get("step_limit_s", 0))  # of processor time; 0: none
        self.folders: list[str] = list(configuration.get("path", []))
        self.simulation = Simulation()
        self._messages = Messages(Path(folder) for folder in configuration.get("messages", []))
        self._components = self._make_components()
        self._outbox: list[bytes | bytearray | memoryview] = []
        self._objects: list[object] = []  # keeps the nodes alive
        self._processes: list[Process] = []
        self._inlets: list[Publisher] = []

    def _make_components(self) -> Components:
        configuration = self._configuration
        environment = Environment(
            path=[SOURCES, *self.folders],
            sources=self.folders,
            messages=list(configuration.get("messages", [])),
            limits=Limits(self.step_limit or _UNLIMITED, float(configuration.get("wall_limit_s", _UNLIMITED))),
            objects=message_objects.of(self._messages, importing=False),
        )
        known = [Configuration.of(node["component"]) for node in configuration.get("nodes", []) if node["component"]]
        return Components(known, environment, self.simulation.spend)

    def start(self, foreign_path: list[str]) -> None:
        """Import the modules and make the nodes; `foreign_path` follows the user's folders in `sys.path`."""
        self._messages.install()
        self._components.install()
        sys.path[:] = [SOURCES, *self.folders, *foreign_path]
        context.enter(self.simulation)
        self._connect_world()
        for node in self._configuration.get("nodes", []):
            self._start_node(node)

    def _connect_world(self) -> None:
        process = self.simulation.add_process("")
        for entry in self._configuration.get("world_publishes", []):
            inlet = Publisher(self.simulation, process, self._type(entry), entry["topic"], _WORLD_OFFERS)
            self._inlets.append(inlet)
        for index, entry in enumerate(self._configuration.get("world_subscribes", [])):
            arguments = self.simulation, process, self._type(entry), entry["topic"], print, _WORLD_REQUESTS
            _Outlet(index, self._outbox, *arguments)

    def _type(self, entry: dict[str, str]) -> type:
        parts = entry["type"].split("/")
        try:
            return self._messages.get(f"{parts[0]}/msg/{parts[-1]}")
        except KeyError as missing:
            raise HostError("message.unknown", f"topic {entry['topic']}: no message type {missing.args[0]}") from None

    def _start_node(self, configuration: dict[str, Any]) -> None:
        name = configuration["name"]
        times = (round(configuration.get(key, 0) * 1e6) for key in ("execution_time_ms", "phase_ms"))
        process = self.simulation.add_process(name, *times)
        self._processes.append(process)
        with self.simulation.starting(process):
            module = importlib.import_module(configuration["module"])
            node_class = getattr(module, configuration["class"], None)
            if not callable(node_class):
                raise HostError(
                    "node.class.missing", f"there is no class {configuration['class']}", module.__file__ or ""
                )
            node = node_class() if _is_rclpy(node_class) else self._start_plain_node(node_class, process)
        self._objects.append(node)

    def _start_plain_node(self, node_class: Any, process: Process) -> Any:
        """Make a node that is a class around DDS readers and writers, and execute it with its period."""
        node = node_class(DomainParticipant())
        for clock in ("now", "wall_clock"):  # by which its inputs become too old, and its messages are stamped
            if hasattr(node_class, clock):
                setattr(node, clock, lambda: self.simulation.now)
        period = int(float(node.period) * NANOSECONDS_PER_SECOND)
        if period <= 0:
            raise ValueError(f"a node needs a period of at least a nanosecond, not {node.period} s")
        self._objects.append(Timer(self.simulation, process, period, node.execute))
        return node

    def ready(self) -> dict[str, Any]:
        """Content of the READY frame."""
        return {
            "python": platform.python_version(),
            "topics": [
                {
                    "topic": topic.name,
                    "publishers": [[_owner(endpoint.process), endpoint.type_name] for endpoint in topic.publishers],
                    "subscriptions": [
                        [_owner(endpoint.process), endpoint.type_name] for endpoint in topic.subscriptions
                    ],
                }
                for _, topic in sorted(self.simulation.topics.items())
            ],
            "warnings": [warning._asdict() for warning in self.simulation.warnings],
        }

    def step(self, payload: memoryview) -> list[bytes | bytearray | memoryview]:
        """Publish the world's samples, let time pass; the content of the STEPPED frame."""
        try:
            until, count = _STEP.unpack_from(payload)
            position = _STEP.size
            for _ in range(count):
                index, length = _STEP_SAMPLE.unpack_from(payload, position)
                position += _STEP_SAMPLE.size
                self.simulation.publish(self._inlets[index], payload[position : position + length])
                position += length
        except (struct.error, IndexError) as problem:
            raise HostError("protocol.frame", f"malformed STEP frame: {problem}") from None
        self.simulation.advance(until)
        samples = self._outbox.copy()
        self._outbox.clear()
        return [_COUNT.pack(len(samples) // 2), *samples]

    def finished(self) -> dict[str, Any]:
        """Content of the FINISHED frame."""
        return {
            "nodes": [{"name": process.name, "activations": process.activations} for process in self._processes],
            "publications": {name: topic.publications for name, topic in sorted(self.simulation.topics.items())},
        }

    def end(self) -> None:
        """End the components, and forget the user's modules, so that those of the next scenario start anew."""
        self._components.end()
        folders = tuple(folder.rstrip("/") + "/" for folder in self.folders)
        for name, module in list(sys.modules.items()):
            places = [getattr(module, "__file__", None) or "", *getattr(module, "__path__", ())]
            if any(place.startswith(folders) for place in places):
                del sys.modules[name]
        importlib.invalidate_caches()


def _is_rclpy(node_class: Any) -> bool:
    """Whether a node makes its own timers, as rclpy has it; one on plain DDS states its period."""
    return not hasattr(node_class, "period") or (isinstance(node_class, type) and issubclass(node_class, Node))


def _owner(process: Process) -> str:
    return process.name or "world"


class Host:
    """Answers frames until the input ends."""

    def __init__(self, channel: Channel, foreign_path: list[str]) -> None:
        self._channel = channel
        self._foreign_path = foreign_path
        self._scenario: Scenario | None = None
        signal.signal(signal.SIGPROF, self._interrupt)

    def run(self) -> int:
        """Serve; the exit code is 1 after a FAILED frame."""
        try:
            while (frame := self._channel.read()) is not None:
                self._answer(*frame)
                signal.setitimer(signal.ITIMER_PROF, 0)
        except KeyboardInterrupt:
            return 130
        except BaseException as error:  # user code may raise anything, even SystemExit
            signal.setitimer(signal.ITIMER_PROF, 0)
            folders = self._scenario.folders if self._scenario else []
            current = self._scenario.simulation.current if self._scenario else None
            self._channel.write_json(Kind.FAILED, describe(error, current.name if current else "", folders))
            return 1
        return 0

    def _answer(self, kind: int, payload: memoryview) -> None:
        if kind == Kind.STEP and self._scenario is not None:
            self._limit()
            self._channel.write(Kind.STEPPED, *self._scenario.step(payload))
        elif kind in (Kind.CONFIGURE, Kind.RESET):
            if self._scenario is not None:
                self._scenario.end()
            self._scenario = Scenario(json.loads(bytes(payload)))
            self._limit()
            self._scenario.start(self._foreign_path)
            gc.unfreeze()
            gc.collect()
            gc.freeze()  # what lives now lives until the end: keep it out of later collections
            self._channel.write_json(Kind.READY, self._scenario.ready())
        elif kind == Kind.FINISH and self._scenario is not None:
            self._channel.write_json(Kind.FINISHED, self._scenario.finished())
        else:
            raise HostError("protocol.frame", f"a frame of kind {kind} is not expected here")

    def _limit(self) -> None:
        """Interrupt nodes that compute longer than the scenario allows for one answer; components have own limits."""
        if self._scenario is not None and self._scenario.step_limit:
            signal.setitimer(signal.ITIMER_PROF, self._scenario.step_limit)

    def _interrupt(self, *_: object) -> None:
        limit = self._scenario.step_limit if self._scenario else 0.0
        raise StepTimeout(f"it used more than {limit:g} s of processor time")


def main() -> int:
    """Serve standard input and output, which user code can no longer reach afterwards."""
    source, target = os.fdopen(os.dup(0), "rb", 1 << 17), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    sys.dont_write_bytecode = True  # a changed file of the same second and size would go unnoticed
    foreign_path = [path for path in sys.path if path not in ("", str(Path.cwd()), SOURCES)]
    return Host(Channel(source, target), foreign_path).run()


if __name__ == "__main__":
    sys.exit(main())
