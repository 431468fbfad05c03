import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory("agv_guard"), "config", "robot.yaml")
    guard = Node(
        package="agv_guard",
        executable="speed_guard",
        namespace="robot",
        parameters=[LaunchConfiguration("config")],
        remappings=[("cmd_vel", "/motors/cmd_vel")],
    )
    return LaunchDescription([DeclareLaunchArgument("config", default_value=config), guard])
