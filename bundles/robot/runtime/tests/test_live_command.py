"""Command line and environment of a single node file."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import FIXTURES
from node_processes import World
from wire import DOMAIN, fresh_tag


@pytest.mark.parametrize("name", ["deadline", "probe:deadline", "/probe:deadline"])
def test_parameters_have_the_types_of_yaml(world: World, name: str) -> None:
    node = world.probe(**{name: "fast"})
    assert node.ends() == 1
    assert any("InvalidParameterTypeException" in line for line in node.said)
    other = world.probe(**{"other:deadline": "fast"})
    other.hears("ready")


def test_parameters_come_from_files_too_and_the_last_value_counts(world: World, tmp_path: Path) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n    period: 0.05\n    fires: 9\n"
        "/room/probe:\n  ros__parameters: {fires: 2}\n"
        "other:\n  ros__parameters: {fires: 5, nested: {deep: [1, 2]}}\n"
    )
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file)
    node.hears("over")
    assert len([line for line in node.said if line.startswith("fired")]) == 2
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file, "-p", "fires:=1")
    node.hears("over")
    assert len([line for line in node.said if line.startswith("fired")]) == 1


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("- 1\n", "below the name of a node"),
        ("probe: {fires: 1}\n", "below the name of a node"),
        ("/room/*: {ros__parameters: {}}\n", "/room/* is not part of Eventchain's runtime"),
        ("probe: [\n", "is not YAML"),
    ],
)
def test_a_wrong_file_of_parameters_is_explained(world: World, tmp_path: Path, text: str, problem: str) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text(text)
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file)
    assert node.ends() == 2
    assert problem in node.said[0]


def test_the_domain_is_that_of_the_environment(world: World) -> None:
    node = world.probe()
    node.hears("ready")
    world.writer("/room/in")
    world.environment["ROS_DOMAIN_ID"] = "first"
    refused = world.probe()
    assert refused.ends() == 2
    assert "error: ROS_DOMAIN_ID is not a number: first" in refused.said


def test_another_domain_is_another_world() -> None:
    tag = fresh_tag()
    one, other = World(DOMAIN, tag), World(DOMAIN + 1, tag)
    try:
        other.probe()
        in_the_other = other.writer("/room/in")
        one.probe()
        assert (one.writer("/room/in").matched(), in_the_other.matched()) == (1, 1)
    finally:
        one.close()
        other.close()


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ([], "there is no file to run"),
        (["no_such_node.py"], "there is no file no_such_node.py"),
        (["--fast", __file__], "unexpected argument --fast"),
        (["--messages"], "unexpected argument --messages"),
        ([__file__, "--ros-args", "-p", "period"], "-p wants NAME:=VALUE"),
        ([__file__, "--ros-args", "-p"], "-p wants NAME:=VALUE"),
        ([__file__, "--ros-args", "-p", "x:=[1"], "the value of parameter x is not YAML: [1"),
        ([__file__, "--ros-args", "-p", "x:={a: 1}"], "parameter x cannot have the value {'a': 1}"),
        ([__file__, "--ros-args", "--params-file", "none.yaml"], "none.yaml cannot be read"),
        ([__file__, "--ros-args", "-r", "a:=b"], "-r is not part of Eventchain's runtime"),
    ],
)
def test_a_wrong_command_line_is_explained(world: World, arguments: list[str], problem: str) -> None:
    node = world.run(*arguments)
    assert node.ends() == 2
    assert node.said[0].startswith(f"error: {problem}")


def test_without_the_library_it_says_what_to_do(world: World) -> None:
    world.environment["EVENTCHAIN_LIBDDSC"] = "/no/such/libddsc.so"
    node = world.probe()
    assert node.ends() == 3
    assert node.said[0].startswith("error: /no/such/libddsc.so cannot be loaded")
    assert node.said[1].startswith("hint: ")


def test_a_folder_of_definitions_is_refused_with_what_to_do(world: World, tmp_path: Path) -> None:
    file = tmp_path / "node.py"
    file.write_text("from own_msgs.msg import Own\n")
    node = world.run("--messages", tmp_path, file)
    assert node.ends() == 2
    assert node.said[0].startswith(f"error: {tmp_path} is a folder; `eventchain messages {tmp_path} > FILE` writes")


def test_a_missing_name_is_said_to_be_missing_here(world: World, tmp_path: Path) -> None:
    source = tmp_path / "node.py"
    source.write_text("from rclpy.qos import QoSNothing\n")
    node = world.run(source)
    assert node.ends() == 1
    assert node.said[-1] == "hint: Eventchain's runtime does not provide this part of rclpy.qos."
