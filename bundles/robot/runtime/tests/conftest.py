"""Common fixtures of the tests."""

from __future__ import annotations

import faulthandler
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

FIXTURES = Path(__file__).with_name("fixtures")
BUNDLE = Path(__file__).parents[1]
CONFINEMENT = BUNDLE.parent / "sandbox" / "src" / "main" / "resources" / "dev" / "eventchain" / "sandbox"
sys.path[:0] = [str(BUNDLE / "python"), str(BUNDLE / "tools"), str(CONFINEMENT)]

from eventchain_ros2 import catalog, context  # noqa: E402
from eventchain_ros2.dds_entities import Participant  # noqa: E402
from eventchain_ros2.messages import Messages  # noqa: E402
from eventchain_ros2.simulation import Simulation  # noqa: E402
from node_processes import World  # noqa: E402
from wire import DEFINITIONS, DOMAIN, fresh_tag, loopback_configuration  # noqa: E402

LONGEST_SECONDS = 600
"""No test takes a tenth of this. One that waits for something that never comes would stop a build without a word."""


@pytest.fixture(autouse=True)
def watchdog() -> Iterator[None]:
    """End the tests, with the lines at which they wait, when one does not end."""
    faulthandler.dump_traceback_later(LONGEST_SECONDS, exit=True, file=sys.__stderr__)
    yield
    faulthandler.cancel_dump_traceback_later()


@pytest.fixture
def messages() -> Messages:
    """Importable message classes: the standard ones and those of the conformance files."""
    messages = Messages(catalog.read([DEFINITIONS]))
    messages.install()
    return messages


@pytest.fixture
def simulation(messages: Messages) -> Iterator[Simulation]:
    """Provide the simulation for the nodes of a test."""
    simulation = Simulation()
    context.enter(simulation)
    yield simulation
    simulation.running = False


@pytest.fixture
def participants() -> Iterator[tuple[Participant, Participant]]:
    """Provide two participants in a domain of their own."""
    configuration = loopback_configuration(fresh_tag())
    with Participant(DOMAIN, configuration) as one, Participant(DOMAIN, configuration) as other:
        yield one, other


@pytest.fixture
def world() -> Iterator[World]:
    """Provide the other side of single node files."""
    world = World(DOMAIN)
    yield world
    world.close()
