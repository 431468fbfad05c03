"""The lock-step host: runs nodes in simulated time, driven over standard input and output.

The protocol is described in this bundle's README.
"""

from __future__ import annotations

import struct
import sys
from typing import Any

from eventchain_ros2.channel import Channel, Kind
from eventchain_ros2.endpoints import Publisher, Subscription
from eventchain_ros2.failures import HostError
from eventchain_ros2.hosting import OBSERVES, Host, HostedNodes, parse, unexpected, world_profile
from eventchain_ros2.node_sources import NodeSources
from eventchain_ros2.processes import WORLD
from eventchain_ros2.qos import qos_profile_default
from eventchain_ros2.simulation import LimitError, Process, Sample

MOST_COMMANDS = 10_000
"""Samples for the world in one step."""

_STEP = struct.Struct("<qH")
_STEP_SAMPLE = struct.Struct("<HI")
_COUNT = struct.Struct("<H")
_STEPPED_SAMPLE = struct.Struct("<qHI")


class _Outlet(Subscription):
    """Subscription of the world: keeps the samples until the step ends."""

    def __init__(self, index: int, target: list[bytes | bytearray | memoryview], *arguments: Any) -> None:
        super().__init__(*arguments)
        self._index = index
        self._target = target

    def receive(self, sample: Sample) -> None:
        if len(self._target) >= 2 * MOST_COMMANDS:
            raise LimitError(f"more than {MOST_COMMANDS:,} commands were published in one step")
        self._target += (_STEPPED_SAMPLE.pack(sample.time, self._index, len(sample.data)), sample.data)


class Scenario(HostedNodes):
    """All nodes of a chain, with the world as one more process."""

    def __init__(self, configuration: dict[str, Any]) -> None:
        super().__init__(configuration)
        self._outbox: list[bytes | bytearray | memoryview] = []
        self._inlets: list[Publisher] = []

    def start(self, sources: NodeSources) -> None:
        """Connect the world and create the nodes."""
        self.prepare(sources)
        self._connect_world()
        self.start_nodes()
        self.simulation.settle()

    def _connect_world(self) -> None:
        process = self.simulation.add_process("")
        for entry in self.configuration.get("world_publishes", []):
            topic, message_type = entry["topic"], self.message_type(entry["type"], entry["topic"])
            profile = world_profile(entry, qos_profile_default)
            self._inlets.append(Publisher(self.simulation, process, message_type, topic, profile))
        for index, entry in enumerate(self.configuration.get("world_subscribes", [])):
            topic, message_type = entry["topic"], self.message_type(entry["type"], entry["topic"])
            profile = world_profile(entry, OBSERVES)
            _Outlet(index, self._outbox, self.simulation, process, message_type, topic, print, profile)

    def ready(self) -> dict[str, Any]:
        """Return the content of the READY frame."""
        return {
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
            "warnings": self.warnings(),
        }

    def step(self, payload: memoryview) -> list[bytes | bytearray | memoryview]:
        """Publish the world's samples, let time pass; return the content of the STEPPED frame."""
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
        """Return the content of the FINISHED frame."""
        return {
            "nodes": self.activations(),
            "publications": {name: topic.publications for name, topic in sorted(self.simulation.topics.items())},
            "answers": self.answers(),
        }


def _owner(process: Process) -> str:
    return process.name or WORLD


class LockstepHost(Host):
    """One process for all nodes, which advances time step by step."""

    scenario: Scenario | None = None

    @property
    def nodes(self) -> HostedNodes | None:
        """Return the nodes of the scenario."""
        return self.scenario

    def answer(self, kind: int, payload: memoryview) -> None:
        """Answer a frame."""
        if kind == Kind.STEP and self.scenario is not None:
            self.limit()
            self.channel.write(Kind.STEPPED, *self.scenario.step(payload))
        elif kind in (Kind.CONFIGURE, Kind.RESET):
            if self.scenario is not None:
                self.scenario.end()
            self.scenario = Scenario(parse(payload))
            self.start(self.scenario.start, self.scenario.ready)
        elif kind == Kind.FINISH and self.scenario is not None:
            self.channel.write_json(Kind.FINISHED, self.scenario.finished())
        else:
            raise unexpected(kind)


if __name__ == "__main__":
    sys.exit(LockstepHost(Channel.of_standard_streams()).run())
