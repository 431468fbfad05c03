"""Compares the bytes that cyclonedds writes for the generated types with those of the messages of ROS 2.

    python wire.py RUNTIME MESSAGES    (with the generated package on the path)

RUNTIME holds the codecs, which are themselves compared with those of ROS 2; MESSAGES is what `eventchain messages`
wrote of the definitions.
"""

import dataclasses
import sys
from pathlib import Path

from fork import messages

sys.path.append(sys.argv[1])  # at the end: cyclonedds stays the real one

from eventchain_ros2 import catalog  # noqa: E402
from eventchain_ros2.messages import Messages, from_cdr, to_cdr  # noqa: E402

CATALOG = Messages(catalog.read([Path(sys.argv[2])]))


def main():
    """Compare new messages, and one with a value in each field."""
    types = [value for name, value in vars(messages).items() if "__" in name and dataclasses.is_dataclass(value)]
    for data_type in types:
        name = data_type.__name__.replace("__", "/msg/", 1)
        ros_type = CATALOG.get(name)
        compare(name, data_type(), ros_type())
    everything = messages.odd_msgs__Everything(
        octets=[1, 2, 3],
        letters=[65, 66],
        flags=[True, False, True],
        few=[0.25],
        blob=list(range(256)),
        words=["", "\u00e4\u00f6"],
        part=messages.odd_msgs__Part(name="a", flags=[True, False]),
        parts=[messages.odd_msgs__Part(name="bc"), messages.odd_msgs__Part(name="def")],
    )
    read = from_cdr(CATALOG.get("odd_msgs/msg/Everything"), everything.serialize(use_version_2=False))
    compare("odd_msgs/msg/Everything", everything, read)
    assert [part.name for part in read.parts] == ["bc", "def"]
    assert read.words == ["", "\u00e4\u00f6"]
    print(f"{len(types) + 1} messages are the same")


def compare(name, plain, ros):
    """The same bytes, up to padding at the end, and the same message again from the bytes of ROS 2."""
    ours, theirs = plain.serialize(use_version_2=False), bytes(to_cdr(ros))
    assert ours == theirs, f"{name}: {ours.hex()} and {theirs.hex()}"
    assert type(plain).deserialize(theirs) == type(plain).deserialize(ours)


if __name__ == "__main__":
    main()
