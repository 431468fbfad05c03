"""Writes sqlite-with-definitions/, a bag in SQLite, with another library: long rows, and several pages of them.

Run in this folder with the development environment of the sandbox: python write_sqlite.py
"""

import shutil
from pathlib import Path

from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

KIND = "".join(f"uint8 KIND_WITH_A_LONG_NAME_{number} = {number}\n" for number in range(250)) + "uint8 value\n"
LARGE = {
    f"demo_msgs/msg/Large{kind}": "".join(f"uint8 A_CONSTANT_OF_{kind}_{number} = {number}\n" for number in range(80))
    for kind in range(4)
}
TARGET = "std_msgs/Header header\nbool valid\nfloat32 distance\ndemo_msgs/Kind kind\n"

store = get_typestore(Stores.ROS2_HUMBLE)
store.register(get_types_from_msg(KIND, "demo_msgs/msg/Kind") | get_types_from_msg(TARGET, "demo_msgs/msg/Target"))

for name, text in LARGE.items():
    store.register(get_types_from_msg(text, name))

folder = Path("sqlite-with-definitions")
shutil.rmtree(folder, ignore_errors=True)
with Writer(folder, version=9, storage_plugin=StoragePlugin.SQLITE3) as bag:
    target = bag.add_connection("/radar/target", "demo_msgs/msg/Target", typestore=store)
    for name in LARGE:
        bag.add_connection("/" + name.rpartition("/")[2].lower(), name, typestore=store)
    flag = bag.add_connection("/brake/active", "std_msgs/msg/Bool", typestore=store)
    for step in range(41):
        bag.write(target, step * 50_000_000, bytes(32))
        if step % 4 == 0:
            bag.write(flag, step * 50_000_000, bytes(5))
