"""Wrong on purpose: it ends the process."""

import os
import sys


class Braking_Decision:
    def execute(self, time_to_collision):
        print("giving up", file=sys.stderr, flush=True)
        os._exit(3)
