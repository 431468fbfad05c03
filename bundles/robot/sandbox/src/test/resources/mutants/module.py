"""Imported by other files, which name Filter and limit of it, and nothing else."""

from rclpy.node import Node

GAIN = 0.5


def limit(value):
    return clipped(value) if value > 3.0 else value


def clipped(value):
    return 4.0


def nobody_names_this(value):
    return value * 7.5


class Filter:
    def __init__(self, node: Node):
        self.value = 0
        self.timer = node.create_timer(0.1, self.update)

    def update(self):
        self.value = self.value + GAIN


class Unused:
    def __init__(self):
        self.value = 8.5


def main():
    print(9.5)
    limit(9.5)
