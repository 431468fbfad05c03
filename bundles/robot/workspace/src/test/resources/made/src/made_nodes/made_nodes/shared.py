import rclpy

from .relays import Relay


def front():
    run("front", 1.5)


def rear():
    run("rear", 2.5)


def run(name, gain):
    rclpy.init()
    rclpy.spin(Relay(name, "/wheels", gain=gain))
