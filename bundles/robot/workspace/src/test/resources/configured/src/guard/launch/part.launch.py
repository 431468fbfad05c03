import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, SetParameter, SetParametersFromFile
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue


def generate_launch_description():
    config = os.path.join(get_package_share_directory("guard"), "config")
    named = DeclareLaunchArgument("config", default_value=os.path.join(config, "all.yaml"))
    substituted = ParameterFile(os.path.join(config, "substituted.yaml"), allow_substs=True)
    return LaunchDescription(
        [
            named,
            GroupAction(
                [
                    SetParameter("limit", 4.5),
                    SetParameter(name="use_sim_time", value=LaunchConfiguration("simulated")),
                    Node(package="guard", executable="limiter", name="in_group", parameters=[substituted]),
                    Node(package="guard", executable="limiter", name="itself", parameters=[{"limit": 5.5}]),
                ]
            ),
            Node(package="guard", executable="limiter", name="behind_group"),
            GroupAction([SetParameter("limit", 6.5)], scoped=False),
            Node(package="guard", executable="limiter", name="behind_open_group"),
            Node(
                package="guard",
                executable="limiter",
                name="typed",
                parameters=[{"limit": ParameterValue(LaunchConfiguration("near", default="7"), value_type=float)}],
            ),
            GroupAction(
                [
                    SetParametersFromFile(LaunchConfiguration("config")),
                    Node(package="guard", executable="filter", name="by_file"),
                ]
            ),
            Node(
                package="guard",
                executable="limiter",
                name="unclear",
                namespace="/unclear",
                parameters=[os.path.join(config, "unclear.yaml")],
            ),
            Node(
                package="guard",
                executable="limiter",
                name="with_arguments",
                arguments=["--ros-args", "-p", "limit:=8.5"],
                ros_arguments=["--log-level", "debug"],
            ),
        ]
    )
