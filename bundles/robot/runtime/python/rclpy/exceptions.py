"""As `rclpy.exceptions`."""

from eventchain_ros2.context import NotInitializedException
from eventchain_ros2.node import InvalidNodeNameException, InvalidTopicNameException
from eventchain_ros2.parameters import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)

__all__ = [
    "InvalidNodeNameException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidTopicNameException",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
]
