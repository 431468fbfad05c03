"""Prints the times of `import rclpy` with this runtime, and of the codec for a scan of 360 beams."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

SOURCES = Path(__file__).resolve().parents[2] / "python"
sys.path.insert(0, str(SOURCES))

from eventchain_ros2.messages import Messages, from_cdr, to_cdr  # noqa: E402

NODE = (
    "import rclpy; from rclpy.node import Node; from eventchain_ros2.messages import Messages; "
    "Messages().install(); from sensor_msgs.msg import LaserScan"
)
STARTS = 20
CALLS = 5000
ROUNDS = 9


def start(statement: str) -> float:
    """Return the median time in s of a Python process that runs this."""
    environment = {**os.environ, "PYTHONPATH": str(SOURCES)}
    taken = []
    for _ in range(STARTS):
        before = time.perf_counter()
        subprocess.run([sys.executable, "-c", statement], env=environment, check=True)
        taken.append(time.perf_counter() - before)
    return statistics.median(taken)


def write_and_read() -> float:
    """Return the median time in s to encode and decode a scan of 360 beams and intensities."""
    scan_class = Messages().get("sensor_msgs/msg/LaserScan")
    scan = scan_class(ranges=[0.25 * beam for beam in range(360)], intensities=[0.0] * 360)
    scan = from_cdr(scan_class, to_cdr(scan))  # with arrays, as a driver sends it
    taken = []
    for _ in range(ROUNDS):
        before = time.perf_counter()
        for _ in range(CALLS):
            from_cdr(scan_class, to_cdr(scan))
        taken.append((time.perf_counter() - before) / CALLS)
    return statistics.median(taken)


def main() -> None:
    """Print the measured values."""
    empty = start("pass")
    for statement in ("import rclpy", NODE):
        print(f"{start(statement) - empty:.3f} s beyond an empty interpreter ({empty:.3f} s): {statement}")
    print(f"{write_and_read() * 1e6:.1f} us: a scan of 360 beams and intensities, written and read")


if __name__ == "__main__":
    main()
