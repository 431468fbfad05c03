"""As `rclpy.exceptions`."""

from eventchain_ros2.context import NotInitializedException
from eventchain_ros2.node import InvalidNodeNameException, InvalidTopicNameException
from eventchain_ros2.parameters import (
    InvalidParameterTypeException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)

__all__ = [
    "InvalidNodeNameException",
    "InvalidParameterTypeException",
    "InvalidTopicNameException",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterNotDeclaredException",
]
