"""Acts as the vehicle: sends scans and speeds to generated nodes in other processes, and prints their answers.

    python peer.py    (with the generated package on the path)
"""

import os
import sys
import time

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from aeb import messages

RELIABLE = Policy.Reliability.Reliable(max_blocking_time=duration(seconds=1))
QOS = Qos(RELIABLE, Policy.History.KeepLast(10), Policy.DataRepresentation(use_cdrv0_representation=True))


def main():
    """Send until there is an answer, since first samples are lost before writers and readers know of each other."""
    participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
    scans = DataWriter(participant, Topic(participant, "rt/scan", messages.sensor_msgs__LaserScan), qos=QOS)
    status_type = messages.carla_msgs__CarlaEgoVehicleStatus
    speeds = DataWriter(participant, Topic(participant, "rt/carla/ego_vehicle/vehicle_status", status_type), qos=QOS)
    numbers = messages.std_msgs__Float32
    times = DataReader(participant, Topic(participant, "rt/aeb/time_to_collision", numbers), qos=QOS)
    forces = DataReader(participant, Topic(participant, "rt/vehicle/brake_force", numbers), qos=QOS)
    # An obstacle is approached with 8 m/s again and again; the time stamps say so, however fast this machine is.
    scan = messages.sensor_msgs__LaserScan(range_min=0.0, range_max=100.0)
    status = status_type(velocity=8.0)
    wanted = {"time_to_collision": lambda value: 0.0 < value < 1.0, "brake_force": lambda value: value == 1.0}
    seen = set()
    count = 0
    end = time.monotonic() + 600
    while len(seen) < 2 and time.monotonic() < end:
        scan.header.stamp.sec, step = divmod(count, 20)
        scan.header.stamp.nanosec = step * 50_000_000
        scan.ranges = [float("inf"), 26.0 - 0.4 * (count % 60), 40.0]
        count += 1
        scans.write(scan)
        speeds.write(status)
        time.sleep(0.05)
        for name, reader in (("time_to_collision", times), ("brake_force", forces)):
            for sample in reader.take(N=10):
                if sample.sample_info.valid_data and wanted[name](sample.data):
                    seen.add(name)
    print("seen: " + ", ".join(sorted(seen)))
    return 0 if len(seen) == 2 else 1


if __name__ == "__main__":
    sys.exit(main())
