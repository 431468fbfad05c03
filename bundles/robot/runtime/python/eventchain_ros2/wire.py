"""A simulation's publishers and subscriptions on DDS.

Samples of other participants arrive here as those of a process outside of the simulation; samples of the simulation's
nodes are sent when they become visible. Within the simulation samples stay in memory.

Samples are identified by their source timestamp, which is unique on a topic: the time in ns at which the sample becomes
visible, plus a small offset that separates writers and simultaneous samples.
"""

from __future__ import annotations

import os
import threading
from collections import deque
from typing import Any

from eventchain_ros2.dds_entities import ClosedError, Participant, Reader, WaitSet, Writer
from eventchain_ros2.processes import LateEndpointError
from eventchain_ros2.qos import HistoryPolicy, QoSProfile
from eventchain_ros2.simulation import Process, Publisher, Sample, Simulation, Subscription, Topic


class Doorbell:
    """Waits for samples in a thread, and signals them on a file descriptor."""

    def __init__(self, participant: Participant) -> None:
        self.wait_set = WaitSet(participant)
        self._source, self._target = os.pipe()
        self._answered = threading.Event()
        self._failure: Exception | None = None
        threading.Thread(target=self._watch, name="samples", daemon=True).start()

    def fileno(self) -> int:
        """Return the descriptor, which is readable from the arrival of samples until `answer`."""
        return self._source

    def answer(self) -> None:
        """Wait for the next samples, after all arrived ones have been taken.

        Raises:
            Exception: any error of the waiting thread.

        """
        os.read(self._source, 1)
        if self._failure is not None:
            raise self._failure
        self._answered.set()

    def _watch(self) -> None:
        try:
            while True:
                if self.wait_set.wait(None):
                    self._answered.clear()
                    os.write(self._target, b"\0")
                    self._answered.wait()
        except ClosedError:
            return
        except Exception as failure:
            self._failure = failure
            os.write(self._target, b"\0")


class Inlet:
    """Publishes the samples of its reader to one subscription."""

    def __init__(self, process: Process, subscription: Subscription, reader: Reader) -> None:
        self.process = process
        self.topic = subscription.topic
        self.type_name = subscription.type_name
        self.qos_profile = subscription.qos_profile
        self.matched = [subscription]
        self.retained: deque[Sample] = deque(maxlen=0)
        self.reader = reader
        self.received = 0

    def decodes(self, data: bytes | bytearray | memoryview) -> bool:
        """Accept all samples: DDS has checked them."""
        return True


class Outlet:
    """Writes the samples of one publisher; for the simulation it is a subscription without a callback."""

    def __init__(self, process: Process, publisher: Publisher, writer: Writer, wire: Wire) -> None:
        self.process = process
        self.publisher = publisher
        self.topic = publisher.topic
        self.type_name = publisher.type_name
        self.qos_profile = publisher.qos_profile
        self.writer = writer
        self.written = 0
        self._wire = wire

    @property
    def count(self) -> int:
        """Return the number of remote subscriptions."""
        return self.writer.matched()

    def receive(self, sample: Sample) -> None:
        """Write a sample."""
        self.writer.write(sample.data, self._wire.stamp(self.topic, sample.sequence))
        self.written += 1


class Stamps:
    """Source timestamps of a topic's samples: received with remote samples, or created for local ones."""

    def __init__(self) -> None:
        self.known: dict[int, int] = {}
        self.given: set[int] = set()  # sequences
        self.turn, self.writers = 0, 1  # index of this writer, and number of writers on the topic
        self._last = 0
        self._next = 0

    def of(self, sequence: int, publications: list[tuple[int, int]]) -> int:
        """Return the stamp of a sample; those of earlier ones are created first, so that stamps increase."""
        while self._next <= sequence:
            if self._next not in self.known:
                self._last = self._after(max(publications[self._next][1], self._last + 1))
                self.known[self._next] = self._last
            self._next += 1
        return self.known[sequence]

    def give(self, sequence: int, stamp: int) -> None:
        """Store the stamp of a remote sample."""
        self.known[sequence] = stamp
        self.given.add(sequence)

    def _after(self, time: int) -> int:
        return time + (self.turn - time) % self.writers


class Wire:
    """Connects all publishers and subscriptions of a simulation's nodes with writers and readers.

    Args:
        participant: their participant.
        doorbell: notification of their samples.
        simulation: simulation of the nodes.

    """

    def __init__(self, participant: Participant, doorbell: Doorbell, simulation: Simulation) -> None:
        self.outlets: list[Outlet] = []
        self.inlets: list[Inlet] = []
        self._participant = participant
        self._doorbell = doorbell
        self._simulation = simulation
        self._outside = simulation.add_process("")
        self._stamps: dict[str, Stamps] = {}
        self._arrived: list[tuple[int, str, Inlet, bytes]] = []
        self._is_sealed = False
        simulation.bridge = self

    def opened(self, endpoint: Any) -> None:
        """Create a writer or reader for an endpoint. The simulation keeps histories: DDS drops no samples."""
        self._require_unsealed(endpoint, "makes")
        arguments = endpoint.topic.name, endpoint.type_name, _without_history(endpoint.qos_profile)
        if hasattr(endpoint, "matched"):
            outlet = Outlet(self._outside, endpoint, self._participant.writer(*arguments), self)
            endpoint.matched.append(outlet)
            self.outlets.append(outlet)
        else:
            inlet = Inlet(self._outside, endpoint, self._participant.reader(*arguments))
            self._doorbell.wait_set.attach(inlet.reader)
            self.inlets.append(inlet)

    def publishers_of(self, subscription: Subscription) -> int:
        """Return the number of matched writers of other processes."""
        return sum(inlet.reader.matched() for inlet in self.inlets if subscription in inlet.matched)

    def closed(self, endpoint: Any) -> None:
        """Close the writer or reader of an endpoint. It stays in the list, whose indices others use."""
        self._require_unsealed(endpoint, "destroys")
        for outlet in self.outlets:
            if outlet.publisher is endpoint:
                outlet.writer.close()
        for inlet in self.inlets:
            if endpoint in inlet.matched:
                inlet.matched.clear()
                inlet.reader.close()

    def seal(self) -> None:
        """Forbid new or destroyed endpoints: all others know the endpoints, and count their samples."""
        self._is_sealed = True

    def _require_unsealed(self, endpoint: Any, verb: str) -> None:
        if self._is_sealed:
            kind = "publisher" if hasattr(endpoint, "matched") else "subscription"
            raise LateEndpointError(f"the node {verb} a {kind} of {endpoint.topic.name} while it runs")

    def take_turns(self, turns: list[list[int]]) -> None:
        """Set the index of each outlet's writer among those on its topic, from 0, and their number."""
        for outlet, (turn, writers) in zip(self.outlets, turns, strict=True):
            stamps = self._stamps_of(outlet.topic.name)
            stamps.turn, stamps.writers = turn, writers

    def collect(self) -> bool:
        """Take the arrived samples for a later `deliver`; return whether there were any."""
        before = len(self._arrived)
        for inlet in self.inlets:
            if inlet.matched:
                for sample in inlet.reader.take():
                    inlet.received += 1
                    self._arrived.append((sample.source_timestamp, inlet.topic.name, inlet, sample.data))
        return len(self._arrived) > before

    @property
    def has_samples(self) -> bool:
        """Return whether collected samples are not yet published."""
        return bool(self._arrived)

    def deliver(self) -> None:
        """Publish the collected samples now, in the order of their source timestamps."""
        self._arrived.sort(key=lambda sample: sample[:2])
        for stamp, topic, inlet, data in self._arrived:
            self._stamps_of(topic).give(len(inlet.topic.publications), stamp)
            self._simulation.publish(inlet, data)
        self._arrived.clear()

    def stamp(self, topic: Topic, sequence: int) -> int:
        """Return the source timestamp of a sample."""
        return self._stamps_of(topic.name).of(sequence, topic.publications)

    def publications(self) -> dict[str, list[tuple[int, int]]]:
        """Return stamp and time of all samples that were published here, by topic."""
        topics = {outlet.topic.name: outlet.topic for outlet in self.outlets}
        return {name: self._published(topic) for name, topic in sorted(topics.items())}

    def _published(self, topic: Topic) -> list[tuple[int, int]]:
        given = self._stamps_of(topic.name).given
        return [(self.stamp(topic, number), time) for number, time in topic.publications if number not in given]

    def events(self) -> list[tuple[str, str, int]]:
        """Return DDS events: `deadline` (missed) or `liveliness` (lost), the topic, and the count."""
        noticed: list[tuple[str, str, int]] = []
        for inlet in self.inlets:
            if inlet.matched:
                noticed.append(("deadline", inlet.topic.name, inlet.reader.missed_deadlines()))
                noticed.append(("liveliness", inlet.topic.name, inlet.reader.lost_writers()))
        return [event for event in noticed if event[2]]

    def stamped(self, samples: list[tuple[str, int]]) -> list[tuple[str, int]]:
        """Return the samples identified by their stamps."""
        topics = self._simulation.topics
        return [(topic, self.stamp(topics[topic], sequence)) for topic, sequence in samples]

    def _stamps_of(self, topic: str) -> Stamps:
        return self._stamps.setdefault(topic, Stamps())

    def close(self) -> None:
        """Close all writers and readers."""
        self._simulation.bridge = None
        for outlet in self.outlets:
            outlet.writer.close()
        for inlet in self.inlets:
            inlet.matched.clear()
            inlet.reader.close()


def _without_history(profile: QoSProfile) -> QoSProfile:
    policies = {name: getattr(profile, name) for name in profile.__slots__ if name not in ("history", "lifespan")}
    return QoSProfile(**policies, history=HistoryPolicy.KEEP_ALL)
