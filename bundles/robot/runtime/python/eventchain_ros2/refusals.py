"""Modules of ROS 2 that are not part of this runtime: their imports fail with a message that says so."""

from __future__ import annotations

_PACKAGES = {
    "action_msgs": "actions",
    "ament_index_python": "index of installed packages",
    "cv_bridge": "OpenCV",
    "diagnostic_updater": "diagnostics",
    "image_transport": "image transport",
    "launch": "launch files",
    "launch_ros": "launch files",
    "message_filters": "message filters",
    "rosbag2_py": "recording by nodes",
    "sensor_msgs_py": "helpers for point clouds",
    "std_srvs": "services",
    "tf2_geometry_msgs": "transforms",
    "tf2_ros": "transforms",
}
_RCLPY = {
    "action": "actions",
    "client": "services",
    "event_handler": "event callbacks",
    "guard_condition": "guard conditions",
    "lifecycle": "managed nodes",
    "service": "services",
    "task": "futures",
    "wait_for_message": "waiting for a message",
}
_SUFFIXES = ("_interfaces", "_msgs")
_SUBPACKAGES = {"action": "actions", "srv": "services"}


def refuse(module: str) -> None:
    """Refuse a module of ROS 2, or of a message package that is not there; do nothing about any other.

    Args:
        module: full name of a module that was not found.

    Raises:
        ModuleNotFoundError: with the part of ROS 2 that is missing.

    """
    package, _, rest = module.partition(".")
    if package == "rclpy" and rest:
        missing = _RCLPY.get(rest.partition(".")[0], f"module '{module}'")
    else:
        missing = _PACKAGES.get(package) or _SUBPACKAGES.get(rest, "")
    if missing:
        raise ModuleNotFoundError(f"No module named '{module}': Eventchain's runtime has no {missing}", name=module)
    if package.endswith(_SUFFIXES) and not rest:
        raise ModuleNotFoundError(f"No module named '{module}': no message package has this name", name=module)
