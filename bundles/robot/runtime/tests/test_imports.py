"""Imports of a node: modules that they find, and answers about parts of ROS 2 that are not there."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import BUNDLE
from eventchain_ros2 import refusals
from eventchain_ros2.messages import Messages
from protocol import HostProcess

FACADE = {file.stem for file in (BUNDLE / "python" / "rclpy").glob("*.py")} - {"__init__"}


@pytest.mark.parametrize(
    ("module", "missing"),
    [
        ("rclpy.action", "Eventchain's runtime has no actions"),
        ("rclpy.lifecycle", "Eventchain's runtime has no managed nodes"),
        ("rclpy.type_support", "Eventchain's runtime has no module 'rclpy.type_support'"),
        ("rclpy_components", "has no composition: run each node in a process of its own"),
        ("tf2_msgs.action", "has no actions: answer with a service"),
        ("geometry_msgs.srv", "has no services of this package: no definition of one was found"),
        ("tf2_ros.async_waitable_transform", "has no module 'tf2_ros.async_waitable_transform'"),
        ("message_filters.nothing", "has no module 'message_filters.nothing'"),
        ("tf2_sensor_msgs", "has no transforms of point clouds: look up"),
        ("nothing_interfaces.msg", "no message package has this name"),
        ("no_such_module", "No module named 'no_such_module'$"),
    ],
)
def test_modules_that_are_missing_are_named(messages: Messages, module: str, missing: str) -> None:
    with pytest.raises(ModuleNotFoundError, match=missing):
        importlib.import_module(module)


def test_names_that_are_missing_are_said_to_be_missing_here(messages: Messages) -> None:
    import rclpy
    import rclpy.qos

    with pytest.raises(AttributeError, match=r"Eventchain's runtime does not provide rclpy\.nothing"):
        rclpy.nothing  # noqa: B018
    with pytest.raises(AttributeError, match=r"Eventchain's runtime does not provide rclpy\.qos\.QoSNothing"):
        rclpy.qos.QoSNothing  # noqa: B018
    with pytest.raises(ImportError, match="cannot import name 'QoSNothing'") as refused:
        exec("from rclpy.qos import QoSNothing")
    assert refusals.hint(refused.value) == "Eventchain's runtime does not provide this part of rclpy.qos."
    with pytest.raises(ModuleNotFoundError, match="has no managed nodes: derive from"):
        exec("from rclpy import lifecycle")
    with pytest.raises(ImportError) as message:
        exec("from std_msgs.msg import Flaot32")
    assert "those of ROS 2 Humble" in refusals.hint(message.value)
    with pytest.raises(ImportError) as other:
        exec("from json import nothing")
    assert refusals.hint(other.value) == "", "what is missing elsewhere is not ours"


@pytest.mark.parametrize("module", sorted(FACADE))
def test_every_module_is_there_without_an_import_of_its_own(module: str) -> None:
    import rclpy

    assert getattr(rclpy, module) is importlib.import_module(f"rclpy.{module}")
    with pytest.raises(AttributeError, match="does not provide"):
        getattr(rclpy, module).nothing  # noqa: B018


def test_the_module_of_nodes_brings_the_others() -> None:
    program = (
        "import rclpy; from rclpy.node import Node; print(rclpy.qos.qos_profile_sensor_data.depth, rclpy.Parameter)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], env={"PYTHONPATH": str(BUNDLE / "python")}, capture_output=True, text=True
    )
    assert done.stdout == "5 <class 'eventchain_ros2.parameters.Parameter'>\n", done.stderr


def test_rclpy_itself_is_not_said_to_be_missing_where_only_its_path_is() -> None:
    refusals.refuse("rclpy")
    refusals.refuse("no_such_module.part")


def test_everything_can_be_imported_in_a_confined_host(tmp_path: Path) -> None:
    packages = ("message_filters", "rclpy", "sensor_msgs_py", "tf2_geometry_msgs", "tf2_ros")
    modules = [
        f"{package}.{file.stem}".removesuffix(".__init__")
        for package in packages
        for file in sorted((BUNDLE / "python" / package).glob("*.py"))
    ]
    lines = [*(f"import {module}" for module in modules), "class It(rclpy.node.Node):"]
    lines += ["    def __init__(self):", "        super().__init__('it')", "        self.buffer = tf2_ros.Buffer()"]
    lines += ["        tf2_ros.TransformListener(self.buffer, self)"]
    (tmp_path / "it.py").write_text("\n".join(lines))
    node = {"module": "it", "class": "It", "name": "it", "component": None}
    with HostProcess() as host:
        ready = host.configure({"path": [str(tmp_path)], "messages": [], "nodes": [node]})
    assert [topic["topic"] for topic in ready["topics"]] == ["/tf", "/tf_static"]
