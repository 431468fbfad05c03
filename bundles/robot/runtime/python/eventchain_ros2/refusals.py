"""Parts of ROS 2 that are not in this runtime: their use fails with a message that says so, and what to do."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

_ACTIONS = "actions: answer with a service, or report progress on a topic"
_LIFECYCLE = "managed nodes: derive from rclpy.node.Node, and do in its constructor what on_configure does"
_PACKAGES = {
    "action_msgs": _ACTIONS,
    "action_tutorials_interfaces": _ACTIONS,
    "ament_index_python": "index of installed packages: pass the path of a file as a parameter",
    "cv_bridge": "OpenCV: read sensor_msgs/msg/Image with NumPy",
    "diagnostic_updater": "diagnostics: publish diagnostic_msgs/msg/DiagnosticArray",
    "image_transport": "image transport: subscribe to sensor_msgs/msg/Image",
    "launch": "launch files: `python -m eventchain_ros2` runs a node file by itself",
    "launch_ros": "launch files: `python -m eventchain_ros2` runs a node file by itself",
    "rclpy_components": "composition: run each node in a process of its own",
    "rosbag2_py": "recording by nodes: `eventchain simulate --mcap` records all topics",
    "tf2_sensor_msgs": "transforms of point clouds: look up the transform, and apply it with NumPy",
}
_RCLPY = {
    "action": _ACTIONS,
    "event_handler": "event callbacks: warnings about quality of service are printed",
    "lifecycle": _LIFECYCLE,
    "qos_event": "event callbacks: warnings about quality of service are printed",
    "qos_overriding_options": "QoS overriding options: pass the profile",
}
_SUFFIXES = ("_interfaces", "_msgs", "_srvs")
_SUBPACKAGES = {"action": _ACTIONS, "srv": "services of this package: no definition of one was found"}
_FACADES = ("message_filters", "rclpy", "sensor_msgs_py", "tf2_geometry_msgs", "tf2_ros")
_RUNTIME = Path(__file__).resolve().parents[1]


def refuse(module: str) -> None:
    """Refuse a module of ROS 2, or of a message package that is not there; do nothing about any other.

    Args:
        module: full name of a module that was not found.

    Raises:
        ModuleNotFoundError: with the part of ROS 2 that is missing.

    """
    package, _, rest = module.partition(".")
    if package in _FACADES and rest:
        missing = _RCLPY.get(rest.partition(".")[0], f"module '{module}'")
    else:
        missing = _PACKAGES.get(package) or _SUBPACKAGES.get(rest, "")
    if missing:
        # Without its name, `from rclpy import lifecycle` lets the error pass instead of replacing its text.
        raise ModuleNotFoundError(f"No module named '{module}': Eventchain's runtime has no {missing}")
    if package.endswith(_SUFFIXES) and not rest:
        raise ModuleNotFoundError(f"No module named '{module}': no message package has this name", name=module)


def of_module(module: str) -> Callable[[str], Any]:
    """Return the `__getattr__` of a module of ROS 2: it names what is missing.

    Args:
        module: full name of the module.

    """

    def refuse_name(name: str) -> Any:
        text = f"module '{module}' has no attribute '{name}'"
        if not name.startswith("__"):
            text += f": Eventchain's runtime does not provide {module}.{name}"
        raise AttributeError(text)

    return refuse_name


def hint(error: BaseException) -> str:
    """Return what an `ImportError` of a name does not say: whether it is this runtime that does not have the name."""
    name, path = getattr(error, "name", None) or "", getattr(error, "path", None) or ""
    if name.endswith((".msg", ".srv")) and not path:
        return f"What {name} has is what your definitions and, for standard packages, those of ROS 2 Humble say."
    ours = name.partition(".")[0] in _FACADES and path and _RUNTIME in Path(path).resolve().parents
    return f"Eventchain's runtime does not provide this part of {name}." if ours else ""
