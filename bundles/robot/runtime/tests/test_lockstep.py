"""The lock-step host over real pipes."""

from __future__ import annotations

import os
import py_compile
import shutil
from pathlib import Path
from typing import Any

import pytest
from protocol import MILLISECOND, RESET, Failed, HostProcess, doubler, float32
from wire import DEFINITIONS

FIXTURES = Path(__file__).with_name("fixtures")


def chain(**node: Any) -> dict[str, Any]:
    """Return a configuration with the node that doubles numbers, every 50 ms."""
    return {
        "path": [str(FIXTURES)],
        "messages": [],
        "nodes": [{**doubler(FIXTURES), "execution_time_ms": 0.0, "phase_ms": 0.0, **node}],
        "world_publishes": [{"topic": "/number", "type": "std_msgs/msg/Float32"}],
        "world_subscribes": [{"topic": "/doubled", "type": "std_msgs/msg/Float32"}],
    }


def test_a_sample_of_the_world_reaches_the_node_and_its_answer_the_world() -> None:
    with HostProcess() as host:
        ready = host.configure(chain())
        assert ready["topics"][0]["topic"] == "/doubled"
        assert ready["warnings"] == []
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(6.0))]


RELAY = """
from rclpy.node import Node
from std_msgs.msg import Float32


class Relay(Node):
    def __init__(self):
        super().__init__("relay")
        self.output = self.create_publisher(Float32, "~/out", 10)
        self.create_subscription(Float32, "in", self.output.publish, 10)
"""


def test_a_node_as_it_is_has_the_names_that_it_is_launched_with(tmp_path: Path) -> None:
    (tmp_path / "relay.py").write_text(RELAY)
    launched = {"name": "front", "namespace": "/car", "remappings": {"in": "/number"}}
    node = {"module": "relay", "class": "Relay", "name": "Relay", "component": None, "node": launched}
    configuration = {**chain(), "path": [str(tmp_path)], "nodes": [node]}
    configuration["world_subscribes"] = [{"topic": "/car/front/out", "type": "std_msgs/msg/Float32"}]
    with HostProcess() as host:
        topics = [each["topic"] for each in host.configure(configuration)["topics"]]
        assert topics == ["/car/front/out", "/number"]
        assert host.step(MILLISECOND, (0, float32(3.0))) == [(0, 0, float32(3.0))]
        (relay,) = host.finish()["nodes"]
        ((_, _, _, reads, writes),) = relay["activations"]
        assert (reads, writes) == ([["/number", 0]], [["/car/front/out", 0]])


MADE = """
import sys

from rclpy.node import Node
from std_msgs.msg import Float32

GAIN = 2.0


class Scale(Node):
    def __init__(self, name, gain=1.0, *, output="out"):
        super().__init__(name)
        self.gain = gain * self.declare_parameter("factor", 1.0).value
        self.output = self.create_publisher(Float32, output, 10)
        self.create_subscription(Float32, "/number", self.on_number, 10)

    def on_number(self, number):
        self.output.publish(Float32(data=self.gain * number.data))


def main():
    Scale("left", GAIN, output="~/scaled")
"""


@pytest.mark.parametrize(
    ("source", "launched", "topic", "factor"),
    [
        (MADE, {}, "/left/scaled", 2.0),
        (MADE, {"parameters": {"factor": 4.0}}, "/left/scaled", 8.0),
        (MADE, {"arguments": {"name": "right", "gain": 5}}, "/out", 5.0),
        (
            MADE.replace("GAIN, output", "float(sys.argv[1]), output").replace("self, name", 'self, name="own"'),
            {},
            "/out",
            1.0,
        ),
    ],
)
def test_a_node_as_it_is_is_made_as_it_is_described_or_as_its_file_makes_it(
    tmp_path: Path, source: str, launched: dict[str, Any], topic: str, factor: float
) -> None:
    (tmp_path / "scale.py").write_text(source)
    launch = {"name": "", "namespace": "", "remappings": {}, **launched}
    node = {"module": "scale", "class": "Scale", "name": "Scale", "component": None, "node": launch}
    configuration = {**chain(), "path": [str(tmp_path)], "nodes": [node]}
    configuration["world_subscribes"] = [{"topic": topic, "type": "std_msgs/msg/Float32"}]
    with HostProcess() as host:
        host.configure(configuration)
        assert host.step(MILLISECOND, (0, float32(3.0))) == [(0, 0, float32(3.0 * factor))]


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


def test_reset_forgets_modules_of_the_folders_before(tmp_path: Path) -> None:
    shutil.copytree(FIXTURES / "chain", tmp_path / "chain", ignore=shutil.ignore_patterns("__pycache__"))
    component = tmp_path / "chain" / "components" / "Doubler.py"
    component.write_text(component.read_text().replace("* 2.0", "* 3.0"))
    with HostProcess() as host:
        host.configure(chain())
        host.configure({**chain(), "path": [str(tmp_path)], "nodes": [doubler(tmp_path)]}, kind=RESET)
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(9.0))]


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("components/Doubler.py", "* 2.0", "* 3.0"),
        ("doubler_node.py", 'data=output["doubled"]', "data=float(3 * 3.0)   "),
    ],
)
def test_a_file_that_is_changed_between_scenarios_is_read_again(
    tmp_path: Path, file: str, before: str, after: str
) -> None:
    shutil.copytree(FIXTURES / "chain", tmp_path / "chain", ignore=shutil.ignore_patterns("__pycache__"))
    changed = tmp_path / "chain" / file
    configuration = {**chain(), "path": [str(tmp_path)], "nodes": [doubler(tmp_path)]}
    with HostProcess() as host:
        host.configure(configuration)
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(6.0))]
        times = changed.stat().st_atime_ns, changed.stat().st_mtime_ns
        text = changed.read_text()
        assert len(before) == len(after)
        changed.write_text(text.replace(before, after))
        os.utime(changed, ns=times)  # same size, same time
        host.configure(configuration, kind=RESET)
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(9.0))]


def test_byte_code_beside_a_node_is_not_trusted(tmp_path: Path) -> None:
    shutil.copytree(FIXTURES / "chain", tmp_path / "chain", ignore=shutil.ignore_patterns("__pycache__"))
    node = tmp_path / "chain" / "doubler_node.py"
    source, stat = node.read_text(), node.stat()
    node.write_text(source.replace('data=output["doubled"]', "data=float(3 * 7.0)   "))
    os.utime(node, ns=(stat.st_atime_ns, stat.st_mtime_ns))
    py_compile.compile(str(node), doraise=True)
    node.write_text(source)
    os.utime(node, ns=(stat.st_atime_ns, stat.st_mtime_ns))
    with HostProcess() as host:
        host.configure({**chain(), "path": [str(tmp_path)], "nodes": [doubler(tmp_path)]})
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == [(50 * MILLISECOND, 0, float32(6.0))]


def test_what_user_code_prints_goes_to_standard_error() -> None:
    with HostProcess() as host:
        host.configure(chain())
        host.step(100 * MILLISECOND, (0, float32(3.0)))
        code, errors = host.close()
        assert code == 0
        assert errors == "activated\n"


def test_four_nodes_in_a_row_pass_their_samples_on() -> None:
    names = ("Detection", "Collision", "Decision", "Control")
    configuration = {
        "path": [str(FIXTURES)],
        "messages": [str(DEFINITIONS)],
        "nodes": [
            {"module": "aeb.nodes", "class": name, "name": name, "component": None, "execution_time_ms": 1.0}
            for name in names
        ],
        "world_publishes": [
            {"topic": "/lidar", "type": "sensor_msgs/msg/PointCloud2"},
            {"topic": "/status", "type": "carla_msgs/CarlaEgoVehicleStatus"},
        ],
        "world_subscribes": [{"topic": "/command", "type": "carla_msgs/msg/CarlaEgoVehicleControl"}],
    }
    with HostProcess() as host:
        host.configure(configuration)
        cloud, status = (b"\0\1\0\0" + bytes(length) for length in (64, 164))
        for step in range(1, 7):
            published = host.step(step * 50 * MILLISECOND, (0, cloud), (1, status))
            assert [time for time, _, _ in published] == (
                [step * 50 * MILLISECOND - 49 * MILLISECOND] if step > 4 else []
            )
        reads = {node["name"]: node["activations"][-1][3] for node in host.finish()["nodes"]}
        assert reads["Collision"] == [["/status", 5], ["/scan", 3]]
        assert reads["Control"] == [["/brake", 1]]


def test_the_same_input_gives_the_same_records() -> None:
    def run() -> list[Any]:
        with HostProcess() as host:
            host.configure(chain(execution_time_ms=7.0, phase_ms=3.0))
            results = [host.step(step * 10 * MILLISECOND, (0, float32(step))) for step in range(1, 50)]
            finished = host.finish()
            for activation in finished["nodes"][0]["activations"]:
                activation[2] = 0
            return [results, finished]

    assert run() == run()


def test_a_frame_at_the_wrong_moment_is_refused() -> None:
    with HostProcess() as host, pytest.raises(Failed, match=r"protocol\.frame"):
        host.step(MILLISECOND)


def test_answers_are_measured_where_they_are_asked_for() -> None:
    with HostProcess() as host:
        host.configure({**chain(), "answers": True})
        for step in range(1, 21):
            host.step(50 * MILLISECOND * step, (0, float32(float(step % 3))))
        ((node, answers),) = host.finish()["answers"].items()
        host.configure(chain(), kind=RESET)
        assert host.finish()["answers"] == {}
    assert node == "Doubler"
    assert {(name, output) for name, output, _, _ in answers} == {("number", "doubled")}
    assert min(delay for *_, delay in answers) == 0
