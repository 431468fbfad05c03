"""What the imports of a node find, and what they say about the parts of ROS 2 that are not there."""

from __future__ import annotations

import importlib
import subprocess
import sys

import pytest
from conftest import BUNDLE
from eventchain_ros2 import refusals
from eventchain_ros2.messages import Messages


@pytest.mark.parametrize(
    ("module", "missing"),
    [
        ("rclpy.action", "Eventchain's runtime has no actions"),
        ("rclpy.lifecycle", "Eventchain's runtime has no managed nodes"),
        ("rclpy.utilities", "Eventchain's runtime has no module 'rclpy.utilities'"),
        ("std_srvs.srv", "Eventchain's runtime has no services"),
        ("sensor_msgs.srv", "Eventchain's runtime has no services"),
        ("tf2_ros.buffer", "Eventchain's runtime has no transforms"),
        ("example_interfaces.msg", "no message package has this name"),
        ("no_such_module", "No module named 'no_such_module'$"),
    ],
)
def test_modules_that_are_missing_are_named(messages: Messages, module: str, missing: str) -> None:
    with pytest.raises(ModuleNotFoundError, match=missing):
        importlib.import_module(module)


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
