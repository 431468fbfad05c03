import threading
from concurrent.futures import ThreadPoolExecutor


class TTC:
    def __init__(self):
        self.pool = ThreadPoolExecutor(1)
        threading.Thread(target=self.track).start()

    def track(self):
        pass

    def execute(self, distance, speed):
        return {"ttc": distance}
