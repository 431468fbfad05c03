import datetime as dt
import time
from datetime import date, datetime
from time import monotonic as now

import numpy as np


class TTC:
    def __init__(self, clock=time.perf_counter):
        self.clock = clock
        self.started = now()

    def execute(self, distance, speed):
        time.sleep(0.01)
        today = (datetime.now(), dt.datetime.utcnow(), date.today(), time.localtime(), time.strftime("%H"))
        stamp = np.datetime64("now")
        return {"ttc": distance if today and stamp else now() - self.started}
