"""Services: requests and replies as samples on two topics, in lock-step as on DDS.

The form is that of ROS 2 on Cyclone DDS (rmw_cyclonedds): the service `/sum` has the topics `rq/sumRequest` and
`rr/sumReply`, and in front of the fields of each sample are the identity of the client and the number of its request.
"""

from __future__ import annotations

import hashlib
import os
import struct
from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

from eventchain_ros2 import catalog
from eventchain_ros2.endpoints import Publisher, Subscription
from eventchain_ros2.messages import Message, from_cdr, to_cdr
from eventchain_ros2.qos import QoSProfile
from eventchain_ros2.simulation import Process, Sample, Simulation
from eventchain_ros2.tasks import Future, follow

_CDR_HEADER = 4
_IDENTITY = 16
_LITTLE, _BIG = struct.Struct("<Qq"), struct.Struct(">Qq")


class Direction(NamedTuple):
    """The names of one direction of a service: the topic's beginning and end, and the end of the type's name."""

    prefix: str
    suffix: str
    message: str

    def topic(self, service: str) -> str:
        """Return the topic of a service."""
        return f"{self.prefix}{service}{self.suffix}"

    def is_topic(self, topic: str) -> bool:
        """Return whether a topic is one of this direction."""
        return topic.startswith(f"{self.prefix}/") and topic.endswith(self.suffix)


REQUEST = Direction("rq", "Request", catalog.REQUEST)
REPLY = Direction("rr", "Reply", catalog.RESPONSE)


def service_of(topic: str, type_name: str) -> tuple[str, str]:
    """Return the name and the type of the service whose requests are on a topic."""
    return topic[len(REQUEST.prefix) : -len(REQUEST.suffix)], type_name.removesuffix(REQUEST.message)


class Identity(NamedTuple):
    """The client of a request, the number of the request, and on DDS the handle of its writer."""

    client: int
    number: int
    writer: int = 0


class _Sender(Publisher):
    """Publishes requests or replies."""

    def __init__(self, owner: str, *arguments: Any) -> None:
        self.owner = owner
        super().__init__(*arguments)

    def send(self, identity: Identity, message: Any) -> None:
        if not isinstance(message, Message) or type(message) is not self.msg_type:
            raise TypeError(f"Expected {self.msg_type}, got {type(message)}")
        data, header = to_cdr(message), _LITTLE.pack(identity.client, identity.number)
        self._simulation.publish(self, bytes(data[:_CDR_HEADER]) + header + bytes(data[_CDR_HEADER:]))

    def decodes(self, data: bytes | bytearray | memoryview) -> bool:
        """Return whether these bytes are a request or reply of its type."""
        return super().decodes(_without_identity(data))


class _Receiver(Subscription):
    """Receives requests or replies, with their identities."""

    def __init__(self, owner: str, *arguments: Any) -> None:
        self.owner = owner
        super().__init__(*arguments)

    def receive(self, sample: Sample) -> None:
        layout = _LITTLE if sample.data[1] & 1 else _BIG
        client, number = layout.unpack_from(sample.data, _CDR_HEADER)
        identity = Identity(client, number, sample.writer)
        self.callback(identity, from_cdr(self.msg_type, _without_identity(sample.data)))  # type: ignore[call-arg]


def _without_identity(data: bytes | bytearray | memoryview) -> bytes:
    return bytes(data[:_CDR_HEADER]) + bytes(data[_CDR_HEADER + _IDENTITY :])


class ServiceIntrospectionState(IntEnum):
    """Listener of requests and responses."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


def _refuse_introspection(state: int) -> None:
    if state != ServiceIntrospectionState.OFF:
        raise NotImplementedError("introspection of services is not part of Eventchain's runtime")


def _identity(simulation: Simulation, client: str) -> int:
    """Return the number of a client: the same in every run in simulated time, and unique in real time."""
    simulation.clients += 1
    salt = b"" if simulation.is_simulated else os.urandom(8)
    text = f"{client} {simulation.clients}".encode()
    return int.from_bytes(hashlib.blake2b(text, digest_size=8, salt=salt).digest(), "little")


def _owner(simulation: Simulation, key: str) -> str:
    """Return what the two ends of a client or server announce in real time, so that others know them as a pair."""
    return "" if simulation.is_simulated else f"{key}={os.urandom(16).hex()}"


class Service:
    """Answers requests with a callback, which is given a request and an empty response, and returns the response."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    def __init__(
        self,
        simulation: Simulation,
        process: Process,
        service_type: Any,
        name: str,
        callback: Callable[[Any, Any], Any],
        qos_profile: QoSProfile,
    ) -> None:
        self.srv_type = service_type
        self.srv_name = self.service_name = name
        self.callback = callback
        self._simulation = simulation
        self._process = process
        request, response = service_type.Request, service_type.Response
        owner = _owner(simulation, "serviceid")
        self._replies = _Sender(owner, simulation, process, response, REPLY.topic(name), qos_profile)
        topic = REQUEST.topic(name)
        self._requests = _Receiver(owner, simulation, process, request, topic, self._answer, qos_profile)

    def _answer(self, identity: Identity, request: Any) -> None:
        result = self.callback(request, self.srv_type.Response())
        follow(self._simulation, self._process, result, lambda response: self.send_response(response, identity))

    def send_response(self, response: Any, header: Identity) -> None:
        """Answer a request.

        Raises:
            TypeError: it is no response of this service.

        """
        peers = self._simulation.service_peers
        if peers is not None:
            peers.wait_for_client(self._requests, self._replies, header.writer)
        self._replies.send(header, response)

    def configure_introspection(
        self, clock: Any, service_event_qos_profile: QoSProfile, introspection_state: int
    ) -> None:
        """Accept that nothing is told of requests and responses; `eventchain` records both."""
        _refuse_introspection(introspection_state)

    def destroy(self) -> None:
        """Stop answering."""
        self._requests.destroy()
        self._replies.destroy()


class Client:
    """Sends requests to a service."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    def __init__(
        self, simulation: Simulation, process: Process, service_type: Any, name: str, qos_profile: QoSProfile
    ) -> None:
        self.srv_type = service_type
        self.srv_name = self.service_name = name
        self._simulation = simulation
        self._process = process
        self._pending: dict[int, Future] = {}
        self._count = 0
        request, response = service_type.Request, service_type.Response
        owner, topic = _owner(simulation, "clientid"), REPLY.topic(name)
        self._replies = _Receiver(owner, simulation, process, response, topic, self._complete, qos_profile)
        self._requests = _Sender(owner, simulation, process, request, REQUEST.topic(name), qos_profile)
        self._identity = _identity(simulation, f"{process.name} {name}")

    def call_async(self, request: Any) -> Future:
        """Send a request; return the future of its response.

        Raises:
            TypeError: it is no request of this service.

        """
        self._count += 1
        future = Future()
        self._pending[self._count] = future  # before it is sent: another thread may receive the answer
        try:
            self._requests.send(Identity(self._identity, self._count), request)
        except BaseException:
            self.remove_pending_request(future)
            raise
        return future

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """Send a request and wait for its response, while another thread spins; None after the time, in seconds.

        Raises:
            RuntimeError: time is simulated, or a callback waits, so that the response would never come.

        """
        if self._simulation.is_simulated or self._simulation.is_within:
            where = "in simulated time" if self._simulation.is_simulated else "within a callback"
            raise RuntimeError(f"{where} call() would wait without end: use call_async(), and `await` its future")
        future = self.call_async(request)
        self._simulation.wait_until(future.done, timeout_sec)
        if not future.done():
            self.remove_pending_request(future)
        return future.result()

    def _complete(self, identity: Identity, response: Any) -> None:
        future = self._pending.pop(identity.number, None) if identity.client == self._identity else None
        if future is not None and not future.cancelled():
            future.set_result(response)

    def remove_pending_request(self, future: Future) -> None:
        """Do not wait for a response any more."""
        self._pending = {number: each for number, each in self._pending.items() if each is not future}

    def service_is_ready(self) -> bool:
        """Return whether a node offers the service."""
        peers = self._simulation.service_peers
        if peers is not None:
            return peers.is_served(self._requests, self._replies)
        return self._requests.get_subscription_count() > 0 and self._replies.get_publisher_count() > 0

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Return whether a node offers the service, within a time in seconds.

        In lock-step, a constructor need not wait, since all nodes start at once: if no node offers it by then, this is
        an error.
        """
        return self._simulation.wait_until(
            self.service_is_ready, timeout_sec, f"node '{self._process.name}' waits for the service '{self.srv_name}'"
        )

    def configure_introspection(
        self, clock: Any, service_event_qos_profile: QoSProfile, introspection_state: int
    ) -> None:
        """Accept that nothing is told of requests and responses; `eventchain` records both."""
        _refuse_introspection(introspection_state)

    def destroy(self) -> None:
        """Stop sending and receiving."""
        self._requests.destroy()
        self._replies.destroy()
        self._pending.clear()
