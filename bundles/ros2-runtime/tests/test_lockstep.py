"""The lock-step host over real pipes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from protocol import MILLISECOND, RESET, Failed, HostProcess, float32

FIXTURES = Path(__file__).with_name("fixtures")


def chain(**node: Any) -> dict[str, Any]:
    """A configuration with the node that doubles numbers, every 50 ms."""
    doubler = {"module": "chain.doubler_node", "class": "Doubler_node", "name": "Doubler"}
    return {
        "path": [str(FIXTURES)],
        "messages": [],
        "nodes": [{**doubler, "execution_time_ms": 0.0, "phase_ms": 0.0, **node}],
        "world_publishes": [{"topic": "/number", "type": "std_msgs/msg/Float32"}],
        "world_subscribes": [{"topic": "/doubled", "type": "std_msgs/msg/Float32"}],
    }


def test_a_sample_of_the_world_reaches_the_node_and_its_answer_the_world() -> None:
    with HostProcess() as host:
        ready = host.configure(chain())
        assert ready["topics"][0]["topic"] == "/doubled"
        assert ready["warnings"] == []
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(6.0))]


def test_a_timer_due_at_the_end_of_a_step_sees_the_samples_published_there() -> None:
    with HostProcess() as host:
        host.configure(chain())
        assert host.step(50 * MILLISECOND) == []
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(6.0))]


def test_publications_become_visible_when_the_execution_time_has_passed() -> None:
    with HostProcess() as host:
        host.configure(chain(execution_time_ms=5.0, phase_ms=12.5))
        assert host.step(15 * MILLISECOND, (0, float32(3.0))) == []
        assert host.step(50 * MILLISECOND) == [(17_500_000, 0, float32(6.0))]
        (node,) = host.finish()["nodes"]
        ((start, end, host_time, reads, writes),) = node["activations"]
        assert (start, end) == (12_500_000, 17_500_000)
        assert host_time > 0
        assert reads == [["/number", 0]]
        assert writes == [["/doubled", 0]]


def test_reset_starts_the_next_scenario_with_fresh_nodes() -> None:
    with HostProcess() as host:
        host.configure(chain())
        host.step(100 * MILLISECOND, (0, float32(3.0)))
        host.configure(chain(), kind=RESET)
        assert host.step(100 * MILLISECOND) == [], "the number of the scenario before must be forgotten"
        assert host.finish()["publications"] == {"/doubled": [], "/number": []}


def test_what_user_code_prints_goes_to_standard_error() -> None:
    with HostProcess() as host:
        host.configure(chain())
        host.step(100 * MILLISECOND, (0, float32(3.0)))
        code, errors = host.close()
        assert code == 0
        assert errors == "activated\n"


def test_a_frame_at_the_wrong_moment_is_refused() -> None:
    with HostProcess() as host, pytest.raises(Failed, match=r"protocol\.frame"):
        host.step(MILLISECOND)
