"""Generated nodes whose inputs fall silent: no command of old values goes on for ever."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from protocol import MILLISECOND, HostProcess, float32

FIXTURES = Path(__file__).with_name("fixtures")
PERIOD = 50 * MILLISECOND
FULL, NONE = float32(1.0), float32(0.0)


def configuration(package: str) -> dict[str, Any]:
    """The node that brakes below a time to collision of 1 s, 20 times a second, with a limit of 250 ms."""
    component = {
        "module": f"{package}.components.Decision",
        "class": "Decision",
        "file": f"{FIXTURES}/{package}/components/Decision.py",
        "inputs": ["ttc"],
        "outputs": [{"name": "force"}],
    }
    node = {"module": f"{package}.decision_node", "class": "Decision_node", "name": "Decision", "component": component}
    return {
        "path": [str(FIXTURES)],
        "messages": [],
        "nodes": [{**node, "execution_time_ms": 0.0, "phase_ms": 0.0}],
        "world_publishes": [{"topic": "/ttc", "type": "std_msgs/msg/Float32"}],
        "world_subscribes": [{"topic": "/force", "type": "std_msgs/msg/Float32"}],
    }


def commands(host: HostProcess, until: int, *samples: tuple[int, bytes]) -> list[bytes]:
    """What was commanded until then."""
    return [data for _, _, data in host.step(until, *samples)]


def test_one_message_and_then_silence_gives_no_thousand_commands() -> None:
    with HostProcess() as host:
        host.configure(configuration("ages_plain"))
        assert commands(host, 1000 * PERIOD, (0, float32(0.5))) == [FULL] * 5
        code, errors = host.close()
    assert code == 0
    assert errors.splitlines() == ["[WARN] [0.300000000] [Decision]: too old: ttc"], "it is said once"


def test_safe_values_are_published_while_the_input_is_too_old() -> None:
    with HostProcess() as host:
        host.configure(configuration("ages_safe"))
        assert commands(host, 1000 * PERIOD, (0, float32(0.5))) == [FULL] * 5 + [NONE] * 994


def test_a_new_message_ends_it_and_the_next_silence_is_said_again() -> None:
    with HostProcess() as host:
        host.configure(configuration("ages_plain"))
        assert commands(host, 20 * PERIOD, (0, float32(0.5))) == [FULL] * 5
        assert commands(host, 40 * PERIOD, (0, float32(5.0))) == [NONE] * 6
        _, errors = host.close()
    assert len(errors.splitlines()) == 2


def test_plain_dds_nodes_have_the_simulated_clock() -> None:
    with HostProcess() as host:
        host.configure(configuration("ages_dds"))
        assert commands(host, 1000 * PERIOD, (0, float32(0.5))) == [FULL] * 6 + [NONE] * 993
        _, errors = host.close()
    assert errors.count("too old: ttc") == 1
