"""Runs the generated node of the runtime's tests; prints the first due time of its timer and the period (ns).

Argument: the folder of its package.
"""

import contextlib
import sys

sys.path.insert(0, sys.argv[1])

import rclpy
from chain.doubler_node import Doubler_node
from rclpy.executors import ExternalShutdownException

rclpy.init()
node = Doubler_node()
print("due", node.timer.due, node.timer.timer_period_ns, flush=True)
with contextlib.suppress(ExternalShutdownException):
    rclpy.spin(node)
