import time
from datetime import datetime, timedelta

import numpy as np


class TTC:
    """A parameter called time is no clock, and neither is a time that is given."""

    def __init__(self):
        self.period = timedelta(milliseconds=20)

    def execute(self, distance, speed, time=0.0):
        shown = datetime.fromtimestamp(12.0).isoformat() + str(np.datetime64("2026-01-01"))
        return {"ttc": distance if shown and hasattr(time, "time") else 0.0}

    def text(self, seconds):
        return time.strftime("%H:%M", time.gmtime(seconds))


if __name__ == "__main__":
    print(time.time())
