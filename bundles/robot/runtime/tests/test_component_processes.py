"""No code of a component shares memory with records, world, harness or another component.

Each file of `fixtures/fakes` replaces the component of the chain and tries to change more than its result. It fails if
the host's output is the same as with the original component, or if the host ends it.
"""

from __future__ import annotations

import shutil
import struct
import textwrap
from pathlib import Path
from typing import Any

import pytest
from protocol import MILLISECOND, RESET, Failed, HostProcess, doubler, float32

FIXTURES = Path(__file__).with_name("fixtures")
FAKES = sorted(file.stem for file in (FIXTURES / "fakes").glob("*.py"))
REFUSED = {
    "acts_between_calls": "component.ended",
    "answers_twice": "component.ended",
    "answers_too_much": "component.ended",
    "answers_garbage": "component.ended",
    "closes_its_channel": "component.ended",
}
STEPS = 4


def configuration(folder: Path, **component: Any) -> dict[str, Any]:
    return {
        "path": [str(folder)],
        "messages": [],
        "nodes": [{**doubler(folder, **component), "execution_time_ms": 5.0, "phase_ms": 12.5}],
        "world_publishes": [{"topic": "/number", "type": "std_msgs/msg/Float32"}],
        "world_subscribes": [{"topic": "/doubled", "type": "std_msgs/msg/Float32"}],
        "step_limit_s": 20.0,
        "wall_limit_s": 600.0,
    }


def scenario(host: HostProcess, folder: Path, kind: int) -> tuple[Any, list[Any], Any]:
    """Return the host's output for a scenario, without host times, which are the last."""
    ready = host.configure(configuration(folder), kind)
    samples = [host.step(50 * MILLISECOND * step, (0, float32(float(step)))) for step in range(1, STEPS + 1)]
    finished = host.finish()
    return ready, samples, finished


def without_host_times(said: tuple[Any, list[Any], Any]) -> Any:
    for node in said[2]["nodes"]:
        for activation in node["activations"]:
            activation[2] = 0
    return said


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """Provide a copy of the chain, whose component is to be replaced."""
    shutil.copytree(FIXTURES / "chain", tmp_path / "chain", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


@pytest.fixture(scope="module")
def honest() -> Any:
    """Provide the host's output with the original component, twice."""
    with HostProcess() as host:
        return [without_host_times(scenario(host, FIXTURES, kind)) for kind in (1, RESET)]


@pytest.mark.parametrize("fake", FAKES)
def test_a_component_changes_nothing_but_its_result(fake: str, project: Path, honest: Any) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    shutil.copy(FIXTURES / "fakes" / f"{fake}.py", component)
    with HostProcess() as host:
        if fake in REFUSED:
            with pytest.raises(Failed) as caught:
                scenario(host, project, 1)
            assert caught.value.details["id"] == REFUSED[fake]
            assert caught.value.details["file"] == str(component)
            assert caught.value.details["node"] == "Doubler"
        else:
            assert [without_host_times(scenario(host, project, kind)) for kind in (1, RESET)] == honest


def test_the_kernel_counts_the_time_of_a_component_that_hides_it(project: Path) -> None:
    shutil.copy(FIXTURES / "fakes" / "lies_about_time.py", project / "chain" / "components" / "Doubler.py")
    with HostProcess() as host:
        (node,) = scenario(host, project, 1)[2]["nodes"]
        assert all(host_time > 20_000_000 for _, _, host_time, _, _ in node["activations"])


def test_what_the_program_may_write_is_not_imported_for_its_components(project: Path) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    component.write_text("import numpy\n" + component.read_text())
    with HostProcess() as host:
        for module in ("numpy", "eventchain_ros2"):
            (host.work / f"{module}.py").write_text("open('imported', 'w').close()\n")
        scenario(host, project, 1)
        assert not (host.work / "imported").exists()


def test_each_component_has_a_process_of_its_own_in_each_scenario(project: Path) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    component.write_text(
        "import os\nimport sys\n\n\nclass Doubler:\n    def execute(self, number):\n"
        "        assert 'eventchain_ros2.simulation' not in sys.modules and os.listdir('.') == []\n"
        "        return {'doubled': float(os.getpid())}\n"
    )
    other = component.with_name("Other.py")
    other.write_text(component.read_text().replace("class Doubler", "class Other"))
    node = project / "chain" / "other_node.py"
    text = (project / "chain" / "doubler_node.py").read_text()
    node.write_text(text.replace("components.Doubler import Doubler", "components.Other import Other as Doubler"))
    processes: list[float] = []
    with HostProcess() as host:
        for kind in (1, RESET):
            settings = configuration(project, outputs=None)
            second = doubler(project, outputs=None, module="chain.components.Other", file=str(other))
            second["component"]["class"] = "Other"
            settings["nodes"].append({**second, "module": "chain.other_node", "name": "Other"})
            host.configure(settings, kind)
            for _, _, data in host.step(200 * MILLISECOND, (0, float32(1.0))):
                processes.append(struct.unpack("<f", data[-4:])[0])
    assert len(set(processes)) == 4
    assert float(host.process.pid) not in processes


@pytest.mark.parametrize(
    "text", ["\x1b[2J\x1b[HPASSED: 10 of 10", "no\nPASSED: 10 of 10", "\u202e\u2066", "x" * 100_000]
)
def test_the_text_of_an_error_is_one_short_line(project: Path, text: str) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    component.write_text(f"class Doubler:\n    def execute(self, number):\n        raise ValueError({text!r})\n")
    with HostProcess() as host, pytest.raises(Failed) as caught:
        scenario(host, project, 1)
    message = caught.value.details["message"]
    assert message.startswith("ValueError: ")
    assert message.isprintable()
    assert len(message) < 600


@pytest.mark.parametrize(
    ("body", "identifier"),
    [
        ("return {'doubled': True}", "component.result.type"),
        ("return {'doubled': '2.0'}", "component.result.type"),
        ("return {'doubled': [2.0]}", "component.result.type"),
        ("return {'doubled': 2}", ""),
        ("import numpy; return {'doubled': numpy.float32(2)}", ""),
        ("import numpy; return {'doubled': numpy.int16(2)}", ""),
        ("import numpy; return {'doubled': numpy.bool_(True)}", "component.result.type"),
    ],
)
def test_a_number_has_to_be_one(project: Path, body: str, identifier: str) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    component.write_text(f"class Doubler:\n    def execute(self, number):\n        {body}\n")
    node = project / "chain" / "doubler_node.py"
    node.write_text(node.read_text().replace('output["doubled"]', 'float(output["doubled"])'))
    with HostProcess() as host:
        host.configure(configuration(project, outputs=[{"name": "doubled", "type": "float32"}]))
        if identifier:
            with pytest.raises(Failed, match=identifier):
                host.step(50 * MILLISECOND, (0, float32(1.0)))
        else:
            assert host.step(50 * MILLISECOND, (0, float32(1.0))) == [(17_500_000, 0, float32(2.0))]


def test_generated_components_keep_to_their_rules_when_they_run(project: Path) -> None:
    component = project / "chain" / "components" / "Doubler.py"
    component.write_text(
        "import os\n\n\nclass Doubler:\n    def execute(self, number):\n        return {'doubled': 1.0}\n"
    )
    with HostProcess() as host:
        host.configure(configuration(project))
    with HostProcess() as host, pytest.raises(Failed) as caught:
        host.configure(configuration(project, restricted=True))
    assert caught.value.details["id"] == "component.import.forbidden"
    assert (caught.value.details["file"], caught.value.details["line"]) == (str(component), 1)


def doubled(folder: Path, **component: Any) -> Any:
    """Return the samples of a scenario with a component that adds a random number."""
    code = """
    class Doubler:
        def __init__(self, random_source=None):
            self._random = random_source

        def execute(self, number):
            return {"doubled": self._random.random()}
    """
    (folder / "chain" / "components" / "Doubler.py").write_text(textwrap.dedent(code))
    with HostProcess() as host:
        return scenario_with(host, folder, **component)


def scenario_with(host: HostProcess, folder: Path, **component: Any) -> list[Any]:
    host.configure(configuration(folder, **component), 1)
    return [host.step(50 * MILLISECOND * step, (0, float32(float(step)))) for step in range(1, STEPS + 1)]


def test_a_component_is_given_random_numbers_by_the_seed(project: Path) -> None:
    first = doubled(project, seed="4/Doubler")
    assert doubled(project, seed="4/Doubler") == first
    assert doubled(project, seed="5/Doubler") != first
    assert len({sample[2] for step in first for sample in step}) > 1
