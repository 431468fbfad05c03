import random

import numpy as np

np.random.seed(3)


class TTC:
    def __init__(self):
        random.seed(7)

    def execute(self, distance, speed):
        return {"ttc": random.random() + np.random.rand()}
