from dataclasses import dataclass


class Base:
    def execute(self, distance, speed):
        return {"ttc": distance / max(abs(speed), 0.1)}


@dataclass
class TTC(Base):
    calls: int = 0
