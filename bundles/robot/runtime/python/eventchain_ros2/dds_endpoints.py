"""Writers and readers on the wire: samples, matched endpoints, and events."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic_ns
from typing import Any, NamedTuple

from eventchain_ros2 import cyclone
from eventchain_ros2.cyclone import ANY_STATE, CountStatus, checked
from eventchain_ros2.dds_qos import LONGEST_BLOCK, policy_name, user_data

GUID_SIZE = 16
OWNERS = ("clientid", "serviceid")
"""Keys in the user data of requests and replies, by which rmw_cyclonedds finds the two ends of a client or server."""

_MOST_TAKEN = 64
_HEADER = 4
_TIMESTAMPS = (2**32 - 1) * 1_000_000_000  # RTPS counts seconds with 32 bits
_ENCODINGS = (b"\x00\x00", b"\x00\x01")  # plain CDR, big and little endian


class ClosedError(RuntimeError):
    """The entity, or the participant it belongs to, was closed."""


class Received(NamedTuple):
    """A sample: its source timestamp (ns), the handle of its writer, and its CDR bytes."""

    source_timestamp: int
    publication: int
    data: bytes


class Peer(NamedTuple):
    """A matched writer or reader: handle, GUID, DDS name of its type, and what its user data announce (`""`: nothing).

    `owner` is the client or server that it belongs to, equal for the two ends of one: `clientid=` or `serviceid=`.
    """

    handle: int
    guid: bytes
    type_name: str
    type_hash: str
    owner: str


class Announced(NamedTuple):
    """Announcement of a writer or reader: the DDS names of its topic and of its type."""

    topic: str
    type_name: str


class Lifetime:
    """State of a participant: whether it is open, and the lock for library calls on its entities."""

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.is_open = True

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the lock.

        Raises:
            ClosedError: the participant is closed.

        """
        with self.lock:
            if not self.is_open:
                raise ClosedError("the participant is closed")
            yield


class _Endpoint:
    """Common part of writers and readers."""

    _peer_function: str
    _count_function: str
    _incompatible_function: str
    _deadline_function: str
    _match_function: str
    event_mask: int
    """The statuses of deadlines, incompatible policies, liveliness and matches."""

    def __init__(self, lifetime: Lifetime, handle: int, topic: str, hashed: str, announced: Announced) -> None:
        self._lifetime = lifetime
        self._library = cyclone.load()
        self._is_open = True
        self.handle = handle
        self.topic = topic
        self.type_hash = hashed
        self.announced = announced
        self.guid = guid_of(handle)
        self._seen: set[int] = set()

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the lock for library calls on this; raise `ClosedError` if it is closed."""
        with self._lifetime.opened():
            if not self._is_open:
                raise ClosedError(f"the {type(self).__name__.lower()} of {self.topic} is closed")
            yield

    def matched(self) -> int:
        """Return the number of matched endpoints."""
        with self.opened():
            return checked(getattr(self._library, self._count_function)(self.handle, None, 0), self.topic)

    def peers(self) -> list[Peer]:
        """Return the matched endpoints."""
        with self.opened():
            count = self.matched() + 8
            handles = (ctypes.c_uint64 * count)()
            found = checked(getattr(self._library, self._count_function)(self.handle, handles, count), self.topic)
            peers = [self._peer(handle) for handle in handles[: min(found, count)]]
        return [peer for peer in peers if peer is not None]

    def _peer(self, handle: int) -> Peer | None:
        found = getattr(self._library, self._peer_function)(self.handle, handle)
        if not found:
            return None  # deleted meanwhile
        endpoint = found[0]
        guid = bytes(endpoint.guid)
        name, announced = endpoint.type_name.decode(errors="replace"), user_data(endpoint.qos)
        self._library.dds_builtintopic_free_endpoint(found)
        owner = next((f"{key}={announced[key]}" for key in OWNERS if key in announced), "")
        return Peer(handle, guid, name, announced.get("typehash", ""), owner)

    def peer(self, handle: int) -> Peer | None:
        """Return a matched endpoint; None: it is gone."""
        with self.opened():
            return self._peer(handle)

    def new_peers(self) -> list[Peer]:
        """Return the endpoints that have matched since the last call and still exist."""
        status = cyclone.MatchedStatus()
        with self.opened():
            checked(getattr(self._library, self._match_function)(self.handle, status), self.topic)
            if not status.total_change and not status.current_change:
                return []
            peers = self.peers()
        new = [peer for peer in peers if peer.handle not in self._seen]
        self._seen = {peer.handle for peer in peers}
        return new

    def incompatible(self) -> str | None:
        """Return the policy of the last incompatible endpoint discovered since the last call; None: there is none."""
        status = self._status(self._incompatible_function)
        return policy_name(status.last & 0xFFFFFFFF) if status.change else None

    def missed_deadlines(self) -> int:
        """Return the number of missed deadlines since the last call."""
        return int(self._status(self._deadline_function).change)

    def _status(self, function: str) -> CountStatus:
        status = CountStatus()
        with self.opened():
            checked(getattr(self._library, function)(self.handle, status), self.topic)
        return status

    def close(self) -> None:
        """Close the endpoint. Closing twice has no effect."""
        with self._lifetime.lock:
            if self._is_open and self._lifetime.is_open:
                self._library.dds_delete(self.handle)
            self._is_open = False


class Writer(_Endpoint):
    """Writes samples of one type on a topic."""

    _peer_function = "dds_get_matched_subscription_data"
    _count_function = "dds_get_matched_subscriptions"
    _incompatible_function = "dds_get_offered_incompatible_qos_status"
    _deadline_function = "dds_get_offered_deadline_missed_status"
    _match_function = "dds_get_publication_matched_status"
    event_mask = 1 << 1 | 1 << 3 | 1 << 9 | 1 << 11

    def __init__(self, lifetime: Lifetime, handle: int, topic: str, hashed: str, announced: Announced) -> None:
        super().__init__(lifetime, handle, topic, hashed, announced)
        sertype = ctypes.c_void_p()
        checked(self._library.dds_get_entity_sertype(handle, sertype), topic)
        self._sertype = sertype.value

    def write(self, cdr_bytes: bytes | bytearray | memoryview, source_timestamp: int | None = None) -> None:
        """Write a sample; wait while reliable readers have not acknowledged enough earlier samples.

        Args:
            cdr_bytes: the sample, with the header of the encapsulation.
            source_timestamp: in ns, from 0 up to 136 years; None: now.

        Raises:
            ValueError: the bytes do not encode the type, or the timestamp is out of range.
            ClosedError: the writer is closed.

        """
        data = bytes(cdr_bytes)
        if len(data) < _HEADER or data[:2] not in _ENCODINGS:
            raise ValueError(f"{self.topic}: a sample starts with the header of plain CDR, not {data[:4].hex()!r}")
        if source_timestamp is not None and not 0 <= source_timestamp < _TIMESTAMPS:
            raise ValueError(f"{self.topic}: {source_timestamp} ns is not a source timestamp")
        padding = -len(data) & 3
        if padding:  # RTPS sends whole words; the header tells readers the number of padding bytes
            data = data[:3] + bytes((padding,)) + data[_HEADER:] + bytes(padding)
        while not self._write(data, source_timestamp):
            pass

    def _write(self, data: bytes, source_timestamp: int | None) -> bool:
        """Try to write; return whether there was room. The time is bounded, so that Python can handle signals."""
        function = self._library.dds_writecdr
        with self.opened():
            vector = cyclone.IoVector(data, len(data))
            kind, size = cyclone.SERDATA_SAMPLE, len(data)
            serialized = self._library.ddsi_serdata_from_ser_iov(self._sertype, kind, 1, vector, size)
            if not serialized:
                raise ValueError(f"{self.topic}: the bytes are no encoding of the topic's type")
            if source_timestamp is not None:
                cyclone.set_source_timestamp(serialized, source_timestamp)
                function = self._library.dds_forwardcdr
            code = function(self.handle, serialized)
        return code != cyclone.TIMEOUT and checked(code, self.topic) == 0

    def wait_for_acknowledgments(self, timeout_ns: int) -> bool:
        """Wait until all reliable readers have acknowledged all samples; return whether they have."""
        return in_slices(timeout_ns, self._acknowledged)

    def _acknowledged(self, timeout_ns: int) -> bool:
        code = self._library.dds_wait_for_acks(self.handle, timeout_ns)
        with self.opened():  # more specific than the return code
            return code != cyclone.TIMEOUT and checked(code, self.topic) == 0

    def assert_liveliness(self) -> None:
        """Assert the liveliness of the writer."""
        with self.opened():
            checked(self._library.dds_assert_liveliness(self.handle), self.topic)

    def lost_liveliness(self) -> int:
        """Return how often the writer lost its liveliness since the last call."""
        return int(self._status("dds_get_liveliness_lost_status").change)


class Reader(_Endpoint):
    """Reads samples of one type on a topic."""

    _peer_function = "dds_get_matched_publication_data"
    _count_function = "dds_get_matched_publications"
    _incompatible_function = "dds_get_requested_incompatible_qos_status"
    _deadline_function = "dds_get_requested_deadline_missed_status"
    _match_function = "dds_get_subscription_matched_status"
    event_mask = 1 << 2 | 1 << 4 | 1 << 10 | 1 << 12

    def __init__(self, lifetime: Lifetime, handle: int, topic: str, hashed: str, announced: Announced) -> None:
        super().__init__(lifetime, handle, topic, hashed, announced)
        self.condition = checked(self._library.dds_create_readcondition(handle, ANY_STATE), topic)
        self._pointers = (ctypes.c_void_p * _MOST_TAKEN)()
        self._infos = (cyclone.SampleInfo * _MOST_TAKEN)()

    def take(self, most: int | None = None) -> list[Received]:
        """Remove and return the samples that have arrived, in the order of their arrival.

        Args:
            most: maximal number; None: all.

        """
        taken: list[Received] = []
        with self.opened():
            while most is None or len(taken) < most:
                wanted = _MOST_TAKEN if most is None else min(most - len(taken), _MOST_TAKEN)
                count = self._library.dds_takecdr(self.handle, self._pointers, wanted, self._infos, ANY_STATE)
                for index in range(checked(count, self.topic)):
                    self._take(self._pointers[index], self._infos[index], taken)
                if count < wanted:
                    break
        return taken

    def _take(self, serialized: Any, info: cyclone.SampleInfo, taken: list[Received]) -> None:
        if info.valid_data:
            size = self._library.ddsi_serdata_size(serialized)
            buffer = (ctypes.c_char * size)()
            self._library.ddsi_serdata_to_ser(serialized, 0, size, buffer)
            padding = buffer.raw[3] & 3  # which the writer's bytes did not contain
            data = buffer.raw[:2] + b"\0\0" + buffer.raw[_HEADER : size - padding]
            taken.append(Received(info.source_timestamp, info.publication_handle, data))
        self._library.ddsi_serdata_unref(serialized)

    def lost_writers(self) -> int:
        """Return the number of writers that have lost their liveliness since the last call."""
        status = cyclone.LivelinessStatus()
        with self.opened():
            checked(self._library.dds_get_liveliness_changed_status(self.handle, status), self.topic)
        return max(int(status.not_alive_change), 0)


def guid_of(handle: int) -> bytes:
    """Return the GUID of an entity, 16 bytes."""
    buffer = (ctypes.c_char * GUID_SIZE)()
    checked(cyclone.load().dds_get_guid(handle, buffer), "entity")
    return bytes(buffer.raw)


def in_slices(timeout_ns: int | None, attempt: Callable[[int], bool]) -> bool:
    """Call `attempt` with short parts of the time, until it succeeds or the time is over."""
    end = None if timeout_ns is None else monotonic_ns() + timeout_ns
    while True:
        left = LONGEST_BLOCK if end is None else max(min(end - monotonic_ns(), LONGEST_BLOCK), 0)
        if attempt(left):
            return True
        if end is not None and monotonic_ns() >= end:
            return False
