"""What tests on the wire share: a domain that nobody else is in, and waiting."""

from __future__ import annotations

import os
import uuid
from collections.abc import Callable
from time import monotonic, sleep

PATIENCE = 120  # s; only a machine that has come to a stop takes that long
DOMAIN = 1 + os.getpid() % 100  # above 100 the ports are those that the system hands out


def fresh_tag() -> str:
    """A tag that no other run has."""
    return uuid.uuid4().hex


def wait_until(condition: Callable[[], object], what: str) -> None:
    """Wait for something that has to happen."""
    end = monotonic() + PATIENCE
    while not condition():
        assert monotonic() < end, f"still waiting: {what}"
        sleep(0.005)
