"""Writes peer.mcap with the MCAP library: two topics of ROS 2 and one channel that is none, in compressed chunks.

Run in this folder with the development environment of the sandbox: python write.py
"""

from pathlib import Path

from mcap.writer import CompressionType, Writer

QOS = """- history: 1
  depth: 5
  reliability: 2
  durability: 2
  deadline:
    sec: 0
    nsec: 50000000
  liveliness: 1
"""
TARGET = """std_msgs/Header header
bool valid
float32 distance # m
demo_msgs/Kind kind
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: demo_msgs/Kind
uint8 CAR = 1
uint8 value
"""

with Path("peer.mcap").open("wb") as file:
    writer = Writer(file, compression=CompressionType.ZSTD)
    writer.start(profile="ros2")
    target = writer.register_schema("demo_msgs/msg/Target", "ros2msg", TARGET.encode())
    flag = writer.register_schema("std_msgs/msg/Bool", "ros2msg", b"bool data\n")
    other = writer.register_schema("a.proto", "protobuf", b"")
    channels = [
        writer.register_channel("/radar/target", "cdr", target, {"offered_qos_profiles": QOS}),
        writer.register_channel("/brake/active", "cdr", flag),
        writer.register_channel("/log", "protobuf", other),
    ]
    for step in range(41):
        for channel in channels[: 1 + (step % 4 == 0) * 2]:
            writer.add_message(channel, step * 50_000_000, bytes(32), step * 50_000_000)
    writer.finish()
