"""A module that a node imports."""

import time


def stamp():
    return time.time()
