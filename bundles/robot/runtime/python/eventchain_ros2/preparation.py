"""Preparation of a host on DDS before its confinement: a participant, with its sockets and threads.

`confined.py` calls this in the process of the host, before the confinement and before any untrusted code.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from eventchain_ros2 import catalog
from eventchain_ros2.dds_entities import Participant
from eventchain_ros2.messages import Messages
from eventchain_ros2.wire import Doorbell

prepared: list[tuple[Participant, Doorbell]] = []
"""Prepared objects, for the host to take."""


def prepare(settings: dict[str, Any]) -> None:
    """Join a domain.

    Args:
        settings: `domain`, a number; `configuration`, XML of Cyclone DDS; `messages`, files of definitions.

    """
    messages = Messages(catalog.read(map(Path, settings["messages"])))
    participant = Participant(settings["domain"], settings["configuration"], messages.catalog, ignore_own=True)
    prepared.append((participant, Doorbell(participant)))
