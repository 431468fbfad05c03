import threading


class TTC:
    def __init__(self):
        self.lock = threading.Lock()

    def execute(self, distance, speed):
        with self.lock:
            return {"ttc": distance}
