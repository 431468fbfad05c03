"""Message classes and their modules."""

from __future__ import annotations

import copy
import importlib
import json
import sys
from array import array
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from eventchain_ros2 import catalog
from eventchain_ros2.definitions import MessageDefinitionError
from eventchain_ros2.messages import Messages, from_cdr, to_cdr


def own(*fields: list[Any], constants: Any = ()) -> Messages:
    """The types, and `own_msgs/msg/Own` with these fields: name, type and default."""
    return Messages({"own_msgs/msg/Own": {"fields": fields, "constants": constants}})


def test_standard_and_own_messages_can_be_imported(messages: Messages) -> None:
    from carla_msgs.msg import CarlaEgoVehicleStatus
    from sensor_msgs.msg import LaserScan

    assert LaserScan.__module__ == "sensor_msgs.msg"
    assert type(CarlaEgoVehicleStatus().control).__name__ == "CarlaEgoVehicleControl"


def test_an_unknown_message_is_an_import_error(messages: Messages) -> None:
    with pytest.raises(ImportError, match="cannot import name 'Sonar'"):
        importlib.import_module("sensor_msgs.msg")
        exec("from sensor_msgs.msg import Sonar")


def test_an_unknown_package_is_an_import_error(messages: Messages) -> None:
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module("no_such_msgs.msg")


def test_all_messages_of_a_package_can_be_imported_at_once(messages: Messages) -> None:
    names: dict[str, Any] = {}
    exec("from geometry_msgs.msg import *", names)
    assert names["Twist"]().linear.x == 0.0
    assert {"Pose", "PoseWithCovarianceStamped", "WrenchStamped"} <= set(names)
    assert "Header" not in names


def test_a_package_on_the_path_wins(messages: Messages, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "std_msgs"
    package.mkdir()
    (package / "__init__.py").write_text("sourced = True\n")
    monkeypatch.syspath_prepend(tmp_path)
    assert importlib.import_module("std_msgs").sourced
    del sys.modules["std_msgs"]


def test_fields_start_with_their_defaults(messages: Messages) -> None:
    from geometry_msgs.msg import PoseWithCovariance, Quaternion
    from sensor_msgs.msg import LaserScan

    assert (Quaternion().x, Quaternion().w) == (0.0, 1.0)
    assert LaserScan().header.stamp.sec == 0
    assert LaserScan().ranges == array("f")
    covariance = PoseWithCovariance().covariance
    assert isinstance(covariance, np.ndarray)
    assert covariance.shape == (36,)
    covariance[0] = 1.0
    assert PoseWithCovariance().covariance[0] == 0.0, "each message has an array of its own"


def test_own_definitions_have_defaults_and_constants() -> None:
    message_class: Any = own(
        ["count", "int32", -2],
        ["unit", "string", "m/s"],
        ["weights", "float64[]", [0.5, 1.0, "inf"]],
        ["words", "string[2]", ["a b", "c"]],
        ["on", "bool", True],
        ["raw", "byte[2]", [1, 2]],
        ["single", "float32", "-inf"],
        constants=[["LIMIT", "int32", 7], ["NAME", "string", "a name"], ["OCTET", "byte", 3]],
    ).get("own_msgs/msg/Own")
    assert (message_class.LIMIT, message_class.NAME, message_class.OCTET) == (7, "a name", b"\3")
    message = message_class()
    assert (message.count, message.unit, message.on, message.single) == (-2, "m/s", True, float("-inf"))
    assert message.weights == array("d", [0.5, 1.0, float("inf")])
    assert message.words == ["a b", "c"]
    assert message.raw == [b"\1", b"\2"]
    assert from_cdr(message_class, to_cdr(message)) == message


def test_own_definitions_hide_standard_ones() -> None:
    hiding = Messages({"std_msgs/msg/Bool": {"fields": [["other", "int8"]], "constants": []}})
    assert hiding.get("std_msgs/msg/Bool").__slots__ == ("other",)  # type: ignore[attr-defined]


def test_definitions_in_an_earlier_file_hide_those_in_a_later_one(tmp_path: Path) -> None:
    files = [tmp_path / "first.json", tmp_path / "second.json"]
    for file in files:
        stated = {"fields": [[file.stem, "int8"]], "constants": []}
        file.write_text(json.dumps({"own_msgs/msg/Own": stated, f"own_msgs/msg/{file.stem}": stated}))
    read = catalog.read(files)
    assert read["own_msgs/msg/Own"]["fields"] == [["first", "int8"]]
    assert sorted(read) == ["own_msgs/msg/Own", "own_msgs/msg/first", "own_msgs/msg/second"]


@pytest.mark.parametrize("text", ["", "[]", "1", "{"])
def test_files_without_definitions_are_refused(tmp_path: Path, text: str) -> None:
    file = tmp_path / "messages.json"
    file.write_text(text)
    with pytest.raises(MessageDefinitionError, match="cannot be read") as caught:
        catalog.read([file])
    assert caught.value.file == str(file)
    with pytest.raises(MessageDefinitionError, match="cannot be read"):
        catalog.read([tmp_path / "nowhere.json"])


@pytest.mark.parametrize(
    "stated",
    [
        {},
        {"fields": []},
        {"fields": [["a"]], "constants": []},
        {"fields": [["a", "int32[x]"]], "constants": []},
        {"fields": [["a", "float32", "fast"]], "constants": []},
        {"fields": [], "constants": [["A", "int8"]]},
    ],
)
def test_what_is_no_definition_is_refused(stated: dict[str, Any]) -> None:
    with pytest.raises(MessageDefinitionError, match="own_msgs/msg/Own is not defined as"):
        Messages({"own_msgs/msg/Own": stated}).get("own_msgs/msg/Own")


def test_a_definition_that_contains_an_unknown_message_names_it() -> None:
    own(["thing", "own_msgs/msg/Missing"]).install()
    with pytest.raises(AttributeError, match="contains the unknown message 'own_msgs/msg/Missing'"):
        importlib.import_module("own_msgs.msg").Own  # noqa: B018


def test_a_definition_that_contains_itself_is_refused() -> None:
    with pytest.raises(MessageDefinitionError, match="contains itself"):
        own(["children", "own_msgs/msg/Own[]"]).get("own_msgs/msg/Own")


def test_the_constructor_takes_known_keywords_only(messages: Messages) -> None:
    from std_msgs.msg import Float32

    assert Float32(data=1.5).data == 1.5
    with pytest.raises(TypeError):
        Float32(1.5)
    with pytest.raises(AssertionError, match="Invalid arguments passed to constructor: value"):
        Float32(value=1.5)
    with pytest.raises(AttributeError):
        Float32().value = 1.5


@pytest.mark.parametrize(
    ("name", "field", "value", "problem"),
    [
        ("std_msgs/msg/Float32", "data", 1, "must be of type 'float' in the range of float32, not 1 \\(int\\)"),
        ("std_msgs/msg/Float32", "data", np.float32(1), "must be of type 'float'"),
        ("std_msgs/msg/Float32", "data", 1e39, "in the range of float32"),
        ("std_msgs/msg/Float32", "data", None, "not None"),
        ("std_msgs/msg/UInt8", "data", 256, r"must be of type 'int' in \[0, 255\], not 256"),
        ("std_msgs/msg/UInt8", "data", 1.0, "must be of type 'int'"),
        ("std_msgs/msg/Bool", "data", 1, "must be of type 'bool'"),
        ("std_msgs/msg/String", "data", b"x", "must be of type 'str'"),
        ("sensor_msgs/msg/LaserScan", "ranges", np.zeros(3), r"numpy arrays have tolist\(\)"),
        ("sensor_msgs/msg/LaserScan", "ranges", [1], "each value of type 'float'"),
        (
            "sensor_msgs/msg/LaserScan",
            "ranges",
            [1.0, float("inf"), -3.4028234664e38],
            "each value of type 'float' in the",
        ),
        ("sensor_msgs/msg/LaserScan", "ranges", [1.0, True], "each value of type 'float'"),
        ("sensor_msgs/msg/PointCloud2", "data", [1, 256], r"each value of type 'int' in \[0, 255\]"),
        ("sensor_msgs/msg/PointCloud2", "data", [1, 1.0], "each value of type 'int'"),
        ("sensor_msgs/msg/LaserScan", "ranges", 1.0, "must be a set or sequence"),
        ("sensor_msgs/msg/LaserScan", "header", 1, "must be of type 'std_msgs/msg/Header'"),
        ("sensor_msgs/msg/PointCloud2", "fields", [1], "each value of type 'sensor_msgs/msg/PointField'"),
        ("geometry_msgs/msg/PoseWithCovariance", "covariance", [1.0], "must have 36 elements"),
        ("shape_msgs/msg/SolidPrimitive", "dimensions", [1.0] * 4, "must have at most 3 elements"),
    ],
)
def test_what_rclpy_refuses_is_refused_when_written(
    messages: Messages, name: str, field: str, value: object, problem: str
) -> None:
    message = messages.get(name)(**{field: value})
    with pytest.raises(AssertionError, match=f"The '{field}' field of {name} .*{problem}"):
        to_cdr(message)


@pytest.mark.parametrize(
    ("name", "field", "value", "read"),
    [
        ("std_msgs/msg/Float64", "data", np.float64(1.5), 1.5),
        ("std_msgs/msg/Float32", "data", float("inf"), float("inf")),
        ("sensor_msgs/msg/LaserScan", "ranges", (1.0, 2.0), array("f", [1.0, 2.0])),
        ("sensor_msgs/msg/LaserScan", "ranges", [], array("f")),
        (
            "sensor_msgs/msg/LaserScan",
            "ranges",
            [float("-inf"), 3.402823466e38],
            array("f", [float("-inf"), 3.402823466e38]),
        ),
        ("sensor_msgs/msg/PointCloud2", "data", [True, 255], array("B", [1, 255])),
        ("sensor_msgs/msg/PointCloud2", "data", b"\1\2", array("B", [1, 2])),
        ("sensor_msgs/msg/PointCloud2", "data", bytearray(b"\1\2"), array("B", [1, 2])),
        ("sensor_msgs/msg/PointCloud2", "data", [1, 2], array("B", [1, 2])),
        ("std_msgs/msg/String", "data", "ä", "ä"),
    ],
)
def test_what_rclpy_accepts_is_accepted(messages: Messages, name: str, field: str, value: object, read: object) -> None:
    message_class = messages.get(name)
    assert getattr(from_cdr(message_class, to_cdr(message_class(**{field: value}))), field) == read


def test_a_list_is_accepted_for_a_fixed_array(messages: Messages) -> None:
    pose = messages.get("geometry_msgs/msg/PoseWithCovariance")
    read = from_cdr(pose, to_cdr(pose(covariance=[float(index) for index in range(36)])))
    assert read.covariance.tolist() == list(range(36))


def test_messages_compare_print_and_copy(messages: Messages) -> None:
    from geometry_msgs.msg import PoseWithCovariance
    from std_msgs.msg import Float32

    assert repr(Float32(data=1.5)) == "std_msgs.msg.Float32(data=1.5)"
    assert Float32(data=1.5) == Float32(data=1.5)
    assert Float32(data=1.5) != Float32(data=2.5)
    pose = PoseWithCovariance()
    twin = copy.deepcopy(pose)
    assert twin == pose
    twin.covariance[3] = 1.0
    assert twin != pose


def test_field_types_are_named_as_rosidl_names_them(messages: Messages) -> None:
    from sensor_msgs.msg import LaserScan
    from shape_msgs.msg import SolidPrimitive

    assert LaserScan.get_fields_and_field_types()["header"] == "std_msgs/Header"
    assert LaserScan.get_fields_and_field_types()["ranges"] == "sequence<float>"
    assert SolidPrimitive.get_fields_and_field_types()["dimensions"] == "sequence<double, 3>"


def test_serialization_functions_of_rclpy(messages: Messages) -> None:
    from rclpy.serialization import deserialize_message, serialize_message
    from std_msgs.msg import Float32

    assert deserialize_message(serialize_message(Float32(data=0.5)), Float32) == Float32(data=0.5)
