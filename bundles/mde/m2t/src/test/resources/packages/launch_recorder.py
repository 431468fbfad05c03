"""Executes a launch file against stand-ins for launch and launch_ros: python launch_recorder.py FILE [NAME:=VALUE]...

They record their arguments as JSON and accept only those that generated files use. This does not show that the
classes of ROS 2 accept them.
"""

import json
import runpy
import sys
from types import ModuleType


def recorder(name, *positional, keywords=()):
    """Returns a stand-in for a class that records its arguments by name."""

    def record(*values, **options):
        unknown = set(options) - set(keywords)
        if len(values) > len(positional) or unknown:
            raise TypeError(f"{name}: {values} {sorted(unknown)}")
        return {"class": name, **dict(zip(positional, values, strict=False)), **options}

    return record


class LaunchConfiguration(dict):
    """Records its name; its value is that of the command line, or empty as if that were the default."""

    def __init__(self, name):
        super().__init__({"class": "LaunchConfiguration", "name": name})

    def perform(self, context):
        """Returns the value."""
        return context.get(self["name"], "")


def started(function):
    """Records the entities that a function returns."""
    arguments = dict(argument.split(":=") for argument in sys.argv[2:])
    return {"class": "OpaqueFunction", "entities": function(arguments)}


def provide(module, **members):
    """Makes a module importable."""
    sys.modules[module] = ModuleType(module)
    vars(sys.modules[module]).update(members)


provide("launch", LaunchContext=dict, LaunchDescription=recorder("LaunchDescription", "entities"))
provide(
    "launch.actions",
    DeclareLaunchArgument=recorder(
        "DeclareLaunchArgument", "name", keywords=["default_value", "description", "choices"]
    ),
    OpaqueFunction=started,
)
provide(
    "launch.substitutions",
    LaunchConfiguration=LaunchConfiguration,
    PathJoinSubstitution=recorder("PathJoinSubstitution", "parts"),
)
provide("launch_ros")
provide(
    "launch_ros.actions",
    Node=recorder("Node", keywords=["package", "executable", "name", "output", "parameters"]),
)
provide("launch_ros.substitutions", FindPackageShare=recorder("FindPackageShare", "package"))
print(json.dumps(runpy.run_path(sys.argv[1])["generate_launch_description"]()))
