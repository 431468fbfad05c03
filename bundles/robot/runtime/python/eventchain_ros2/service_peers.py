"""The other ends of services on DDS, as rmw_cyclonedds tells them apart.

A client has two ends, and so has a server; DDS discovers each by itself. A request that arrives before the reply's
reader is known would be answered to nobody, and a server that is known by one end only cannot be asked yet.
"""

from __future__ import annotations

from collections.abc import Mapping
from time import monotonic_ns, sleep
from typing import Any

from eventchain_ros2.dds_endpoints import ClosedError, Peer, Reader, Writer
from eventchain_ros2.processes import Publisher, Subscription

LONGEST_WAIT = 100_000_000
"""Time for which an answer waits for its reader, in ns, as in rmw_cyclonedds."""

_STEP = 0.002
_PARTICIPANT = 12
"""Bytes of a GUID that name the participant."""


class Matched:
    """Clients and servers among the matched writers and readers of a participant.

    Args:
        writers: the writers, by their publishers; may change later.
        readers: the readers, by their subscriptions; may change later.
        longest_wait: the time for which an answer waits for its reader, in ns.

    """

    def __init__(
        self,
        writers: Mapping[Any, Writer],
        readers: Mapping[Any, Reader],
        longest_wait: int = LONGEST_WAIT,
    ) -> None:
        self._writers = writers
        self._readers = readers
        self._longest_wait = longest_wait
        self._given_up: set[int] = set()

    def is_served(self, requests: Publisher, replies: Subscription) -> bool:
        """Return whether both ends of a server are matched; of those that announce no pairs, any two ends."""
        writer, reader = self._writers.get(requests), self._readers.get(replies)
        if writer is None or reader is None:
            return False
        try:
            return not {peer.owner for peer in writer.peers()}.isdisjoint(peer.owner for peer in reader.peers())
        except ClosedError:
            return False

    def wait_for_client(self, requests: Subscription, replies: Publisher, writer: int) -> None:
        """Wait until the reader of a client is matched, but not for long: before, replies do not reach it.

        Of a client that announces no pair, the reader is one of the same participant. If there is none, replies no
        longer wait for this client. The wait ends when the client is gone.
        """
        reader, answers = self._readers.get(requests), self._writers.get(replies)
        if reader is None or answers is None or writer in self._given_up:
            return
        end = monotonic_ns() + self._longest_wait
        try:
            while (client := reader.peer(writer)) is not None and not any(
                _belong(client, each) for each in answers.peers()
            ):
                if monotonic_ns() >= end:
                    self._given_up.add(writer)
                    return
                sleep(_STEP)
        except ClosedError:
            return


def _belong(one: Peer, other: Peer) -> bool:
    """Return whether two ends belong to one client."""
    if one.owner or other.owner:
        return one.owner == other.owner
    return one.guid[:_PARTICIPANT] == other.guid[:_PARTICIPANT]
