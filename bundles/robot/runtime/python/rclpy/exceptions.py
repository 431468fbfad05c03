"""As `rclpy.exceptions`."""

from eventchain_ros2 import refusals
from eventchain_ros2.context import NotInitializedException
from eventchain_ros2.endpoints import ROSInterruptException
from eventchain_ros2.node import InvalidNodeNameException, InvalidServiceNameException, InvalidTopicNameException
from eventchain_ros2.parameters import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)

__all__ = [
    "InvalidNodeNameException",
    "InvalidParameterTypeException",
    "InvalidParameterValueException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "NotInitializedException",
    "ParameterAlreadyDeclaredException",
    "ParameterImmutableException",
    "ParameterNotDeclaredException",
    "ParameterUninitializedException",
    "ROSInterruptException",
]
__getattr__ = refusals.of_module(__name__)
