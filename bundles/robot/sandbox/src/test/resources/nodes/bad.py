"""A node that follows the clock of the computer: in itself, in what it calls, and perhaps elsewhere."""

import random
import threading
import time
from datetime import datetime

from rclpy.node import Node

try:
    STARTED = time.time()
except OSError:
    STARTED = 0.0


def age():
    return elapsed(STARTED)


def elapsed(since):
    return time.monotonic() - since


class Brake(Node):
    def __init__(self):
        super().__init__("brake")
        self.worker = threading.Thread(target=self.step)

    def step(self):
        time.sleep(0.01)
        self.value = age() + random.random()


class Recorder(Node):
    def step(self):
        self.name = datetime.now().isoformat()


def main():
    time.sleep(1.0)
