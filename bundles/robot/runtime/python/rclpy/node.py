"""As `rclpy.node`, which loads the other modules: programs then use `rclpy.qos` without an import of its own."""

from eventchain_ros2.node import Node
from eventchain_ros2.parameters import Parameter

from rclpy import callback_groups as callback_groups
from rclpy import clock as clock
from rclpy import duration as duration
from rclpy import exceptions as exceptions
from rclpy import executors as executors
from rclpy import logging as logging
from rclpy import parameter as parameter
from rclpy import publisher as publisher
from rclpy import qos as qos
from rclpy import subscription as subscription
from rclpy import time as time
from rclpy import timer as timer

__all__ = ["Node", "Parameter"]
