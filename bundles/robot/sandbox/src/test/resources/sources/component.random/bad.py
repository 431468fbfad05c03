import os
import random
import secrets
from random import gauss
from uuid import uuid4

import numpy as np
from numpy.random import default_rng


class TTC:
    def __init__(self):
        self.own = random.Random()
        self.numpy = default_rng()
        self.none = random.Random(None)
        self.name = str(uuid4())

    def execute(self, distance, speed):
        noise = random.random() + gauss(0.0, 1.0) + np.random.rand()
        more = secrets.randbelow(3) + os.urandom(1)[0] + random.SystemRandom().random()
        return {"ttc": distance + noise + more}
