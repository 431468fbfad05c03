from dataclasses import dataclass


@dataclass
class TTC:
    gain: float = 1.0

    def execute(self, distance, speed):
        return {"ttc": distance * self.gain}
