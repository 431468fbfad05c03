"""Prints the cost of the lock-step host: start, reset, and a step of 50 ms of a chain of four nodes at 20 Hz.

Each step has a PointCloud2 of 4,000 points (64 kB), as in scenarios that do not say otherwise, and a vehicle status.
The components do almost nothing.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any

TESTS = Path(__file__).resolve().parents[1]
SANDBOX = TESTS.parents[1] / "sandbox/src/main/resources/dev/eventchain/sandbox"
sys.path[:0] = [str(TESTS), str(TESTS.parent / "python"), str(SANDBOX)]

from eventchain_ros2.catalog import read  # noqa: E402
from eventchain_ros2.lockstep import Scenario  # noqa: E402
from eventchain_ros2.messages import Messages, from_cdr, to_cdr  # noqa: E402
from eventchain_ros2.node_sources import NodeSources  # noqa: E402
from protocol import MILLISECOND, RESET, HostProcess, step_payload  # noqa: E402

FIXTURES = TESTS / "fixtures"
DEFINITIONS = TESTS.parents[1] / "messages" / "conformance" / "definitions.json"
STEPS = 4000
MESSAGES = 20_000
STEP = 50 * MILLISECOND


def configuration() -> dict[str, Any]:
    """Return the configuration of the chain of four nodes."""
    names = ("Detection", "Collision", "Decision", "Control")
    times = {"execution_time_ms": 1.0, "phase_ms": 0.0}
    return {
        "path": [str(FIXTURES)],
        "messages": [str(DEFINITIONS)],
        "nodes": [{"module": "aeb.nodes", "class": name, "name": name, "component": None, **times} for name in names],
        "world_publishes": [
            {"topic": "/lidar", "type": "sensor_msgs/msg/PointCloud2"},
            {"topic": "/status", "type": "carla_msgs/msg/CarlaEgoVehicleStatus"},
        ],
        "world_subscribes": [{"topic": "/command", "type": "carla_msgs/msg/CarlaEgoVehicleControl"}],
    }


def world(messages: Messages) -> list[tuple[int, bytes]]:
    """Return the samples of a step."""
    fields = [messages.get("sensor_msgs/msg/PointField")(name=name, datatype=7, count=1) for name in "xyzi"]
    cloud = messages.get("sensor_msgs/msg/PointCloud2")(width=4000, point_step=16, data=bytes(64000), fields=fields)
    status = messages.get("carla_msgs/msg/CarlaEgoVehicleStatus")(velocity=13.9)
    return [(0, bytes(to_cdr(cloud))), (1, bytes(to_cdr(status)))]


def show(what: str, seconds: float, unit: float = 1e6) -> None:
    """Print a measured value."""
    print(f"{what:56}{seconds * unit:10.1f} {'us' if unit == 1e6 else 'ms'}")


def measure_processes(samples: list[tuple[int, bytes]]) -> None:
    """Measure start, reset and steps of a host in its own process."""
    start = time.perf_counter()
    with HostProcess(stderr=subprocess.DEVNULL) as host:
        host.configure(configuration())
        show("start of the process until READY", time.perf_counter() - start, 1e3)
        start = time.perf_counter()
        host.configure(configuration(), RESET)
        show("RESET until READY", time.perf_counter() - start, 1e3)
        start = time.perf_counter()
        for number in range(1, STEPS + 1):
            host.step(number * STEP, *samples)
        taken = (time.perf_counter() - start) / STEPS
        show("step over pipes, with this end of them", taken)
        print(f"{'times real time':56}{STEP / 1e9 / taken:10.0f}")
        start = time.perf_counter()
        result = host.finish()
        show(f"FINISH after {STEPS} steps", time.perf_counter() - start, 1e3)
        host_times = [sum(a[2] for a in node["activations"]) for node in result["nodes"]]
        show("callbacks of the four timers, per step", sum(host_times) / STEPS / 1e9)


def measure_scenario(samples: list[tuple[int, bytes]]) -> None:
    """Measure steps without the pipes."""
    scenario = Scenario(configuration())
    scenario.start(NodeSources())
    payloads = [memoryview(step_payload(number * STEP, *samples)) for number in range(1, STEPS + 1)]
    start = time.perf_counter()
    for payload in payloads:
        scenario.step(payload)
    show("step within the process", (time.perf_counter() - start) / STEPS)


def measure_codec(messages: Messages) -> None:
    """Measure single messages."""
    scan_class = messages.get("sensor_msgs/msg/LaserScan")
    scan = scan_class(ranges=[1.0] * 360)
    for name, message in (("LaserScan of 360 beams", from_cdr(scan_class, to_cdr(scan))),):
        data = bytes(to_cdr(message))
        start = time.perf_counter()
        for _ in range(MESSAGES):
            to_cdr(message)
        show(f"write a {name}", (time.perf_counter() - start) / MESSAGES)
        start = time.perf_counter()
        for _ in range(MESSAGES):
            from_cdr(type(message), data)
        show(f"read a {name}", (time.perf_counter() - start) / MESSAGES)


def main() -> None:
    """Print all figures."""
    messages = Messages(read([DEFINITIONS]))
    samples = world(messages)
    measure_codec(messages)
    measure_scenario(samples)
    measure_processes(samples)


if __name__ == "__main__":
    main()
