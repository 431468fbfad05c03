from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, SetParameter


def generate_launch_description():
    ld = LaunchDescription()
    ld.add_action(DeclareLaunchArgument("node_name", default_value="from_argument"))
    ld.add_action(
        Node(
            package="corner_nodes",
            executable="kept",
            name=LaunchConfiguration("node_name"),
            remappings=[("kept", "kept_here"), ("output", LaunchConfiguration("nowhere"))],
        )
    )
    space = LaunchConfiguration("space_of_part", default="")
    ld.add_action(DeclareLaunchArgument("space_of_part", default_value=space))
    ld.add_action(Node(package="corner_nodes", executable="kept", name="in_no_space", namespace=space))
    for index in range(2):
        ld.add_action(Node(package="corner_nodes", executable="kept", name=f"kept_{index}"))
    ld.add_action(OpaqueFunction(function=print))
    ld.add_action(SetParameter("use_sim_time", True))
    ld.add_action(SetParameter("rate", 5))
    limits = {"limit": 1.5, "sides": ["left", "right"], "nested": {"deep": True}}
    ld.add_action(
        Node(
            package="corner_nodes",
            executable="kept",
            name="with_parameters",
            parameters=[
                limits,
                {"use_sim_time": True, "gain": LaunchConfiguration("gain", default="2.0"), "open": print},
                "config.yaml",
            ],
        )
    )
    changed = {"limit": 1.5}
    changed["limit"] = 2.5
    ld.add_action(Node(package="corner_nodes", executable="kept", name="with_changed", parameters=[changed]))
    return ld
