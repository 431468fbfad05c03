"""Common part of tests on the wire: an isolated domain, samples, and waiting."""

from __future__ import annotations

import json
import os
import uuid
from collections.abc import Callable
from pathlib import Path
from time import monotonic, sleep
from typing import Any

from eventchain_ros2.dds_entities import Participant, Reader, Received, Writer
from eventchain_ros2.qos import HistoryPolicy, QoSProfile

PATIENCE = 120  # s; only exceeded on a stalled machine
DOMAIN = 1 + os.getpid() % 100  # above 100 the ports are in the ephemeral range
MILLISECOND = 1_000_000
SECOND = 1_000 * MILLISECOND
LATEST = (2**32 - 1) * SECOND - 1
STRING, SCAN = "std_msgs/msg/String", "sensor_msgs/msg/LaserScan"
EVERY = QoSProfile(history=HistoryPolicy.KEEP_ALL)
TEXT = b"\0\1\0\0\2\0\0\0x\0"


CONFORMANCE = Path(__file__).parents[2] / "messages" / "conformance"
DEFINITIONS = CONFORMANCE / "definitions.json"
"""Definitions besides the standard ones, as Java resolves them."""
TABLE: dict[str, Any] = json.loads((CONFORMANCE / "wire.json").read_text(encoding="utf-8"))
"""The facts of DDS that both sides are tested against."""


def loopback_configuration(tag: str) -> str:
    """Return the configuration of a domain on this machine only, as the simulation passes it to nodes."""
    return str(TABLE["loopback"]["configuration"]).replace(TABLE["loopback"]["tag"], tag)


def fresh_tag() -> str:
    """Return a tag that no other run has."""
    return uuid.uuid4().hex


def wait_until(condition: Callable[[], object], what: str) -> None:
    """Wait for an event that has to happen."""
    end = monotonic() + PATIENCE
    while not condition():
        assert monotonic() < end, f"still waiting: {what}"
        sleep(0.005)


def connected(
    participants: tuple[Participant, Participant], type_name: str = STRING, profile: QoSProfile = EVERY
) -> tuple[Writer, Reader]:
    writer = participants[0].writer("/topic", type_name, profile)
    reader = participants[1].reader("/topic", type_name, profile)
    wait_until(lambda: writer.matched() and reader.matched(), "a match")
    return writer, reader


def reach_echo(writer: Writer, reader: Reader, sample: bytes) -> None:
    """Write a sample to an echo in another process until it comes back, and take all that is still on its way.

    Matches seen from here are not enough: what is written before the other side knows these endpoints, too, is lost.
    """
    wait_until(lambda: writer.matched() and reader.matched(), "the other process")
    written, returned = 0, 0
    end = monotonic() + PATIENCE
    while not returned or returned < written:
        assert monotonic() < end, "still waiting: an echo"
        if not returned:
            written += 1
            writer.write(sample, written)
        sleep(0.02)
        returned = max([returned, *(each.source_timestamp for each in reader.take())])


def take(reader: Reader, count: int) -> list[Received]:
    taken: list[Received] = []
    wait_until(lambda: taken.extend(reader.take()) or len(taken) >= count, f"{count} samples")
    return taken
