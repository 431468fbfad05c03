"""Runs the generated nodes in the lock-step host: python travel.py PACKAGE_FOLDER, prints what comes out at last.

The folder of the host's protocol (bundles/robot/runtime/tests) is on PYTHONPATH.
"""

import json
import struct
import sys
from pathlib import Path

from protocol import MILLISECOND, HostProcess

ORDER = ["Steering", "Vehicle_Detection", "Lane_Detection", "Camera"]


def distance(value):
    """CDR bytes of a sensor_msgs/msg/Range: header, radiation type, angle, limits, and the range at last."""
    return b"\0\1\0\0" + struct.pack("<iIIxBxx4f", 0, 0, 1, 0, 0.1, 0.0, 100.0, value)


def configuration(folder):
    """All nodes of the chain as the manifest has them, its input and its output."""
    nodes = json.loads(Path(folder, "eventchain-manifest.json").read_text())["nodes"]
    for node in nodes:
        node["component"]["file"] = str(Path(folder, node["component"]["file"]))
    return {
        "path": [folder],
        "nodes": sorted(nodes, key=lambda node: ORDER.index(node["name"])),
        "world_publishes": [{"topic": "/road", "type": "sensor_msgs/msg/Range"}],
        "world_subscribes": [{"topic": "/steering/angle", "type": "std_msgs/msg/Float32"}],
    }


def main(folder):
    """Let half a second pass for each of two values; print what the warnings and the last outputs are."""
    with HostProcess(stderr=None) as host:
        ready = host.configure(configuration(folder))
        angles = []
        for until, value in ((500, 8.0), (1000, 4.0)):
            (*_, (_, _, data)) = host.step(until * MILLISECOND, (0, distance(value)))
            angles += struct.unpack("<f", data[4:])
        print(json.dumps({"warnings": ready["warnings"], "angles": angles}))


if __name__ == "__main__":
    main(sys.argv[1])
