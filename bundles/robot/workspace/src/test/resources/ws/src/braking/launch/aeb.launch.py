import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_ros.actions import Node
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource


def generate_launch_description():
    perception = os.path.join(get_package_share_directory("radar_tracker"), "launch", "perception.launch.xml")
    brake = Node(package="braking", executable="brake", namespace="brake", name="brake_request")
    return LaunchDescription(
        [
            IncludeLaunchDescription(XMLLaunchDescriptionSource(perception)),
            brake,
            Node(package="braking", executable="warning"),
        ]
    )
