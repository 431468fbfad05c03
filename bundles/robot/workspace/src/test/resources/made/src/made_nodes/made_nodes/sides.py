import rclpy
from rclpy.executors import SingleThreadedExecutor

from .relays import Relay

TARGETS = "scaled"


def main(args=None):
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    gain = 3.0
    executor.add_node(Relay("left", "/sides/left", target=TARGETS, gain=gain))
    executor.add_node(Relay("right", "/sides/right", period=1 / 50))
    executor.spin()
