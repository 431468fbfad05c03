"""Generated nodes: commands from stale values stop, and messages have the time of their publication.

The nodes are the expected output of the templates (TemplateCasesTest in bundles/mde/m2t).
"""

from __future__ import annotations

import json
import shutil
import struct
from pathlib import Path
from typing import Any

import pytest
from protocol import MILLISECOND, HostProcess, float32

GENERATED = Path(__file__).parents[3] / "mde" / "m2t" / "src" / "test" / "resources" / "cases"
PERIOD = 50 * MILLISECOND
FULL, NONE = float32(1.0), float32(0.0)

BRAKE = '''
class Braking_Decision:
    """Full force below one second."""

    def execute(self, ttc):
        """Return the force."""
        return {"brake_force": 1.0 if ttc < 1.0 else 0.0}
'''
OPTIONS = '''
class options:
    """Passes a distance on, and says when it was measured."""

    def execute(self, best):
        """Return all outputs."""
        return {"done": False, "distance": best, "heard": 1000}
'''


def configuration(folder: Path, case: str, component: str, source: str, topics: dict[str, str]) -> dict[str, Any]:
    """Return a generated node, copied to a folder, with its component; the world publishes the first topic."""
    (package,) = (GENERATED / case / "expected").iterdir()
    copy = folder / package.name
    shutil.copytree(package, copy)
    nodes = json.loads((copy / "eventchain-manifest.json").read_text())["nodes"]
    (node,) = (node for node in nodes if node["name"] == component)
    file = copy / node["component"]["file"]
    file.write_text(source)
    node["component"]["file"] = str(file)
    (offered, *taken) = ({"topic": topic, "type": kind} for topic, kind in topics.items())
    return {
        "path": [str(copy)],
        "messages": [],
        "nodes": [{**node, "execution_time_ms": 0.0, "phase_ms": 0.0}],
        "world_publishes": [offered],
        "world_subscribes": taken,
    }


@pytest.fixture
def brake(tmp_path: Path) -> dict[str, Any]:
    """Return a node that brakes below a time to collision of 1 s, 20 times a second, with a limit of 250 ms."""
    topics = {"/aeb/ttc": "std_msgs/msg/Float32", "/vehicle/brake_force": "std_msgs/msg/Float32"}
    return configuration(tmp_path, "ros2-python/aeb", "Braking_Decision", BRAKE, topics)


@pytest.fixture(params=["ros2-python", "cyclonedds-python"])
def options(tmp_path: Path, request: pytest.FixtureRequest) -> dict[str, Any]:
    """Return a node with safe values for two of its topics, 20 times a second, with a limit of 62.5 ms."""
    topics = {
        "/best": "std_msgs/msg/Float32",
        "/done": "std_msgs/msg/Bool",
        "/distance": "sensor_msgs/msg/Range",
        "/heard": "sensor_msgs/msg/Temperature",
    }
    return configuration(tmp_path, f"{request.param}/topics", "options", OPTIONS, topics)


def commands(host: HostProcess, until: int, *samples: tuple[int, bytes]) -> list[bytes]:
    """Return the commands until then."""
    return [data for _, _, data in host.step(until, *samples)]


def stamps(samples: list[tuple[int, int, bytes]], topic: int) -> list[tuple[int, int]]:
    """Return the stamps of the messages on a topic of the world, seconds and nanoseconds."""
    return [struct.unpack_from("<iI", data, 4) for _, index, data in samples if index == topic]


def test_one_message_and_then_silence_gives_no_thousand_commands(brake: dict[str, Any]) -> None:
    with HostProcess() as host:
        host.configure(brake)
        assert commands(host, 1000 * PERIOD, (0, float32(0.5))) == [FULL] * 5
        code, errors = host.close()
    assert code == 0
    assert errors.splitlines() == ["[WARN] [0.300000000] [braking_decision]: too old: ttc"], "it is said once"


def test_a_new_message_ends_it_and_the_next_silence_is_said_again(brake: dict[str, Any]) -> None:
    with HostProcess() as host:
        host.configure(brake)
        assert commands(host, 20 * PERIOD, (0, float32(0.5))) == [FULL] * 5
        assert commands(host, 40 * PERIOD, (0, float32(5.0))) == [NONE] * 6
        _, errors = host.close()
    assert len(errors.splitlines()) == 2


def test_safe_values_are_published_while_the_input_is_too_old(options: dict[str, Any]) -> None:
    with HostProcess() as host:
        host.configure(options)
        samples = host.step(1000 * PERIOD, (0, float32(0.5)))
        _, errors = host.close()
    ages = [bool(data[4]) for _, index, data in samples if index == 0]
    executed = ages.count(False)
    assert 1 <= executed <= 2
    assert ages == [False] * executed + [True] * (999 - executed)
    assert errors.count("too old: best") == 1


def test_headers_have_the_simulated_time_also_those_of_safe_values(options: dict[str, Any]) -> None:
    with HostProcess() as host:
        host.configure(options)
        samples = host.step(50 * PERIOD, (0, float32(0.5)))
    times = [time for time, index, _ in samples if index == 1]
    assert len(times) == 49
    assert stamps(samples, 1) == [divmod(time, 1_000_000_000) for time in times]


def test_a_stamp_of_the_component_is_kept(options: dict[str, Any]) -> None:
    with HostProcess() as host:
        host.configure(options)
        samples = host.step(50 * PERIOD, (0, float32(0.5)))
    assert set(stamps(samples, 2)) == {(1000, 0)}
