"""Writes on /PREFIX_back the bytes that it reads on /PREFIX_out, and does nothing else. Arguments: PREFIX, type."""

import sys

from eventchain_ros2.dds_entities import Participant, WaitSet
from eventchain_ros2.qos import QoSProfile

prefix, type_name = sys.argv[1:3]
packages = {"Float32": "std_msgs", "LaserScan": "sensor_msgs"}
with Participant(1) as participant:
    profile = QoSProfile(depth=10)
    writer = participant.writer(f"/{prefix}_back", f"{packages[type_name]}/msg/{type_name}", profile)
    reader = participant.reader(f"/{prefix}_out", f"{packages[type_name]}/msg/{type_name}", profile)
    waiting = WaitSet(participant)
    waiting.attach(reader)
    while True:
        waiting.wait(None)
        for sample in reader.take():
            writer.write(sample.data)
