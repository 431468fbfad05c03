"""Announced writers and readers of a domain, including those without a match."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager

from eventchain_ros2 import cyclone
from eventchain_ros2.cyclone import ANY_STATE, checked
from eventchain_ros2.dds_endpoints import Announced, Lifetime
from eventchain_ros2.dds_qos import announced_profile
from eventchain_ros2.qos import QoSProfile

WRITERS, READERS = 0x7FFF0003, 0x7FFF0004
"""The library's topics for them: DDS_BUILTIN_TOPIC_DCPSPUBLICATION and DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION."""

_ALIVE = 1 << 4
_MOST_TAKEN = 64


class Announcements:
    """The existing writers, or readers. Closed with their participant.

    Args:
        lifetime: lifetime of the participant.
        participant: handle of the participant.
        topic: `WRITERS` or `READERS`.

    """

    def __init__(self, lifetime: Lifetime, participant: int, topic: int) -> None:
        self._lifetime = lifetime
        self._library = cyclone.load()
        self._there: dict[int, tuple[Announced, QoSProfile, bytes]] = {}
        with lifetime.opened():
            self._handle = checked(self._library.dds_create_reader(participant, topic, None, None), "discovery")
            self.condition = checked(self._library.dds_create_readcondition(self._handle, ANY_STATE), "discovery")

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the lock for library calls on this; raise `ClosedError` if the participant is closed."""
        with self._lifetime.opened():
            yield

    def there(self) -> set[Announced]:
        """Return the current announcements."""
        return {announced for announced, _, _ in self.known()}

    def profiles(self, topic: str) -> list[QoSProfile]:
        """Return the policies of those on a topic, by its DDS name, that are known now."""
        return [profile for announced, profile, _ in self.known() if announced.topic == topic]

    def known(self) -> list[tuple[Announced, QoSProfile, bytes]]:
        """Return the current announcements with their policies and GUIDs."""
        samples = (ctypes.c_void_p * _MOST_TAKEN)()
        infos = (cyclone.SampleInfo * _MOST_TAKEN)()
        with self.opened():
            while True:
                count = self._library.dds_take(self._handle, samples, infos, _MOST_TAKEN, _MOST_TAKEN)
                for sample, info in zip(samples[: checked(count, "discovery")], infos, strict=False):
                    self._note(sample, info)
                if not count:
                    return list(self._there.values())
                self._library.dds_return_loan(self._handle, samples, count)

    def _note(self, sample: int | None, info: cyclone.SampleInfo) -> None:
        if info.instance_state != _ALIVE:
            self._there.pop(info.instance_handle, None)
        elif info.valid_data and sample:
            endpoint = cyclone.Endpoint.from_address(sample)
            names = (name.decode(errors="replace") for name in (endpoint.topic_name, endpoint.type_name))
            self._there[info.instance_handle] = Announced(*names), announced_profile(endpoint.qos), bytes(endpoint.guid)
