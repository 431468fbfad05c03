from __future__ import annotations

import random
import uuid

import numpy as np


class TTC:
    def __init__(self, random_source: random.Random | None = None):
        self.random = random_source or random.Random(7)
        self.numpy = np.random.default_rng(seed=7)
        self.generator: np.random.Generator = np.random.Generator(np.random.PCG64(1))
        self.name = uuid.uuid5(uuid.NAMESPACE_DNS, "ttc")

    def execute(self, distance, speed):
        return {"ttc": self.random.gauss(0.0, 1.0) + self.numpy.normal()}
