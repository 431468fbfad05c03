"""A node by its own clock; what `main` does is not hosted."""

import random
import threading
import time

import rclpy
from rclpy.node import Node


class Brake(Node):
    def __init__(self):
        super().__init__("brake")
        self.noise = random.Random(7)
        self.create_timer(0.1, self.step)

    def step(self):
        self.since = self.get_clock().now()


def main():
    rclpy.init()
    threading.Thread(target=rclpy.spin, args=(Brake(),)).start()
    time.sleep(1.0)


if __name__ == "__main__":
    main()
