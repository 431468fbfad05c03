"""Reports of the host about errors in user code, messages or the other side."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from typing import Any

import pytest
from protocol import MILLISECOND, Failed, HostProcess, doubler, float32

FIXTURES = Path(__file__).with_name("fixtures")
COMPONENT = """class Doubler:
    def execute(self, number):
        {body}
"""


def configuration(folder: Path, **changes: Any) -> dict[str, Any]:
    return {
        "path": [str(folder)],
        "nodes": [doubler(folder)],
        "world_publishes": [{"topic": "/number", "type": "std_msgs/msg/Float32"}],
        **changes,
    }


@pytest.fixture
def chain(tmp_path: Path) -> Path:
    """Provide a copy of the chain, to be modified."""
    shutil.copytree(FIXTURES / "chain", tmp_path / "chain", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def spoil(folder: Path, text: str, file: str = "components/Doubler.py") -> Path:
    path = folder / "chain" / file
    path.write_text(text)
    return path


def failure(folder: Path, **changes: Any) -> dict[str, Any]:
    """Return the host's report for one step with the number 3."""
    with HostProcess() as host:
        with pytest.raises(Failed) as caught:
            host.configure(configuration(folder, **changes))
            host.step(100 * MILLISECOND, (0, float32(3.0)))
        code, _ = host.close()
        assert code == 1
    return caught.value.details


def test_an_error_in_a_component_is_reported_with_its_place(chain: Path) -> None:
    file = spoil(chain, COMPONENT.format(body='return {"doubled": 1 / (number - number)}'))
    details = failure(chain)
    assert details["id"] == "component.raised"
    assert details["message"] == "ZeroDivisionError: float division by zero"
    assert details["node"] == "Doubler"
    assert (details["file"], details["line"]) == (str(file), 3)
    assert details["column"] == (28 if sys.version_info >= (3, 11) else 0)
    assert details["excerpt"] == '        return {"doubled": 1 / (number - number)}'
    assert details["traceback"].startswith("Traceback")


def test_the_innermost_user_frame_is_the_place_even_within_a_library(chain: Path) -> None:
    spoil(chain, "import json\n" + COMPONENT.format(body='return json.loads("{")'))
    details = failure(chain)
    assert (details["id"], details["line"]) == ("component.raised", 4)


def test_a_component_that_exits_is_reported(chain: Path) -> None:
    spoil(chain, COMPONENT.format(body="raise SystemExit(0)"))
    assert failure(chain)["message"] == "SystemExit: 0"


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ("while True: pass", "it used more than 0.2 s of processor time"),
        ("import time; time.sleep(60)", "it did not answer within 1 s"),
    ],
)
def test_a_component_that_hangs_is_ended_and_reported_where_it_is(chain: Path, body: str, message: str) -> None:
    careful = f"""while True:
            try:
                {body}
            except BaseException:
                pass"""
    file = spoil(chain, COMPONENT.format(body=careful))
    details = failure(chain, step_limit_s=0.2, wall_limit_s=1.0 if "sleep" in body else 600.0)
    assert (details["id"], details["message"]) == ("component.timeout", message)
    assert (details["file"], details["line"]) == (str(file), 5)


def test_a_node_that_computes_without_end_is_interrupted_where_it_is(chain: Path) -> None:
    file = chain / "chain" / "doubler_node.py"
    file.write_text(file.read_text().replace('print("activated")', "while True: pass"))
    details = failure(chain, step_limit_s=0.2)
    assert (details["id"], details["message"]) == ("node.timeout", "it used more than 0.2 s of processor time")
    assert (details["file"], details["line"]) == (str(file), 24)


@pytest.mark.parametrize(
    ("body", "identifier", "message"),
    [
        ("return number", "component.result.type", "execute() returned float, not dict"),
        ("pass", "component.result.type", "execute() returned NoneType, not dict"),
        ('return {"doubled": None}', "component.result.type", "execute() returned NoneType for 'doubled'"),
        (
            'return {"double": 1.0}',
            "component.result.keys",
            "execute() returned a dict without doubled and with double",
        ),
        (
            'return {"doubled": 1.0, 7: 2}',
            "component.result.keys",
            "execute() returned a dict with 7",
        ),
        ('return {"doubled": float("nan")}', "component.result.nan", "execute() returned nan for 'doubled'"),
        ('return {"doubled": float("inf")}', "component.result.nan", "execute() returned inf for 'doubled'"),
        (
            'return {"doubled": [1.0, float("nan")]}',
            "component.result.nan",
            "execute() returned nan in 'doubled' at index 1",
        ),
    ],
)
def test_a_wrong_result_is_reported_where_it_is_returned(chain: Path, body: str, identifier: str, message: str) -> None:
    file = spoil(chain, COMPONENT.format(body=body))
    details = failure(chain)
    assert (details["id"], details["message"]) == (identifier, message)
    returns = (2, 5, "    def execute(self, number):") if body == "pass" else (3, 9, f"        {body}")
    assert (details["line"], details["column"], details["excerpt"]) == returns
    assert details["file"] == str(file)


def test_infinity_may_stand_in_a_sequence(chain: Path) -> None:
    spoil(chain, COMPONENT.format(body='return {"doubled": [float("inf"), -float("inf")]}'))
    details = failure(chain)
    assert details["id"] == "node.failed", "the check lets it pass; only Float32 does not take a list"
    assert details["message"].startswith("AssertionError: The 'data' field of std_msgs/msg/Float32 must be")


def test_without_outputs_a_missing_key_is_an_error_of_the_node(chain: Path) -> None:
    spoil(chain, COMPONENT.format(body='return {"double": 1.0}'))
    details = failure(chain, nodes=[doubler(chain, outputs=None)])
    assert (details["id"], details["message"]) == ("node.failed", "KeyError: 'doubled'")
    assert Path(details["file"]).name == "doubler_node.py"


def test_a_component_that_does_not_parse_is_reported_with_its_place(chain: Path) -> None:
    file = spoil(chain, "class Doubler:\n    def execute(self, number)\n        return 1\n")
    details = failure(chain)
    assert details["id"] == "component.syntax"
    assert (details["file"], details["line"]) == (str(file), 2)
    assert details["excerpt"] == "    def execute(self, number)"
    assert details["node"] == "Doubler"


def test_a_node_that_does_not_parse_is_reported(chain: Path) -> None:
    spoil(chain, "def broken(:\n", "doubler_node.py")
    assert failure(chain)["id"] == "node.syntax"


def test_an_error_while_a_node_is_made_is_reported(chain: Path) -> None:
    text = (
        "from rclpy.node import Node\n\n\nclass Doubler_node(Node):\n    def __init__(self):\n        self.timers[0]\n"
    )
    spoil(chain, text, "doubler_node.py")
    details = failure(chain)
    assert (details["id"], details["line"]) == ("node.failed", 6)


def test_a_missing_class_or_module_is_reported(chain: Path) -> None:
    spoil(chain, "", "doubler_node.py")
    assert failure(chain)["id"] == "node.class.missing"
    (chain / "chain" / "doubler_node.py").unlink()
    assert failure(chain)["message"] == "ModuleNotFoundError: No module named 'chain.doubler_node'"


def test_an_unknown_message_of_the_world_is_reported(chain: Path) -> None:
    details = failure(chain, world_publishes=[{"topic": "/number", "type": "std_msgs/msg/Number"}])
    assert (details["id"], details["message"]) == (
        "message.unknown",
        "topic /number: no message type std_msgs/msg/Number",
    )


def test_a_file_without_definitions_is_reported(chain: Path) -> None:
    file = chain / "messages.json"
    file.write_text("[]")
    details = failure(chain, messages=[str(file)], world_publishes=[{"topic": "/own", "type": "own_msgs/msg/Own"}])
    assert (details["id"], details["file"]) == ("message.definition", str(file))


def test_malformed_samples_are_reported(chain: Path) -> None:
    with HostProcess() as host:
        host.configure(configuration(chain))
        with pytest.raises(Failed, match=r"message\.malformed: std_msgs/msg/Float32"):
            host.step(MILLISECOND, (0, b"\0\1\0\0\0"))


def test_a_sample_for_an_unknown_topic_is_refused(chain: Path) -> None:
    with HostProcess() as host:
        host.configure(configuration(chain))
        host.step(100 * MILLISECOND)
        with pytest.raises(Failed, match=r"protocol\.frame") as caught:
            host.step(MILLISECOND, (1, float32(1.0)))
        assert caught.value.details["node"] == "", "no node is to blame"


def test_a_frame_that_ends_early_is_reported() -> None:
    with HostProcess() as host:
        assert host.process.stdin is not None
        host.process.stdin.write(b"\xff\0\0\0\1")
        host.process.stdin.close()
        with pytest.raises(Failed, match=r"protocol\.frame: the input ended within a frame"):
            host.receive(2)


def test_user_code_cannot_reach_the_protocol(chain: Path) -> None:
    body = 'import os, sys; os.write(1, b"raw"); print("text"); assert os.read(0, 1) == b""; return {"doubled": 1.0}'
    spoil(chain, COMPONENT.format(body=body))
    with HostProcess() as host:
        host.configure(configuration(chain))
        assert host.step(100 * MILLISECOND, (0, float32(3.0))) == []
        assert sorted(host.close()[1].split()) == ["activated", "rawtext"]


def test_modules_of_the_current_folder_are_not_imported(chain: Path) -> None:
    with HostProcess() as host:
        (host.work / "std_msgs").mkdir()
        (host.work / "std_msgs" / "__init__.py").write_text("raise SystemExit")
        host.configure(configuration(chain))
        assert host.step(MILLISECOND) == []


def test_commands_without_end_are_not_taken(chain: Path) -> None:
    node = chain / "chain" / "doubler_node.py"
    text = node.read_text()
    publish = 'self.publisher.publish(Float32(data=output["doubled"]))'
    node.write_text(text.replace(publish, f"for _ in range(10_001):\n            {publish}"))
    details = failure(chain, world_subscribes=[{"topic": "/doubled", "type": "std_msgs/msg/Float32"}])
    assert details["id"] == "simulation.limit"
    assert details["message"] == "more than 10,000 commands were published in one step"


def test_a_frequency_of_another_magnitude_ends_the_scenario(chain: Path) -> None:
    node = chain / "chain" / "doubler_node.py"
    node.write_text(node.read_text().replace("1.0 / 20.0, self.execute", "0.000_000_1, lambda: None"))
    details = failure(chain)
    assert details["id"] == "simulation.limit"
    assert details["node"] == "Doubler"
