"""Executes a launch file against stand-ins for launch and launch_ros: python launch_recorder.py FILE [NAME:=VALUE]...

They record what they are given, as JSON, and know no more arguments than what generated files use; whether ROS 2's
own classes take these is not shown by that.
"""

import json
import runpy
import sys
from types import ModuleType


def recorder(name, *positional, keywords=()):
    """A class that records its arguments, under the names of its positional ones."""

    def record(*values, **options):
        unknown = set(options) - set(keywords)
        if len(values) > len(positional) or unknown:
            raise TypeError(f"{name}: {values} {sorted(unknown)}")
        return {"class": name, **dict(zip(positional, values, strict=False)), **options}

    return record


class LaunchConfiguration(dict):
    """Records its name, and has the value of the command line; else none, as if that were the default."""

    def __init__(self, name):
        super().__init__({"class": "LaunchConfiguration", "name": name})

    def perform(self, context):
        """Its value."""
        return context.get(self["name"], "")


def started(function):
    """Records what the function starts."""
    arguments = dict(argument.split(":=") for argument in sys.argv[2:])
    return {"class": "OpaqueFunction", "entities": function(arguments)}


def provide(module, **members):
    """Make a module importable."""
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
