"""Write `humble.msgs` of `messages`, the standard message definitions of ROS 2 Humble.

The definitions come from the type store of `rosbags`. Run it after raising the pinned version of rosbags:
`python tools/extract_standard_messages.py`. A test of `messages` resolves them to `python/eventchain_ros2/humble.json`.
"""

from __future__ import annotations

from pathlib import Path

from rosbags.typesys import Stores, get_typestore

TARGET = Path(__file__).parents[2] / "messages/src/main/resources/dev/eventchain/messages/humble.msgs"
SEPARATOR = "=" * 80

# The type store drops default values of fields. Only those of Quaternion are not zero (common_interfaces).
DEFAULTS = {"geometry_msgs/msg/Quaternion": {"float64 w": "float64 w 1"}}


def definitions() -> str:
    """Return all definitions, sorted by name, each under a `MSG: package/msg/Name` line."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    parts = []
    for name in sorted(store.fielddefs):
        text = store.generate_msgdef(name, ros_version=2)[0].split(SEPARATOR)[0].strip()
        for field, replacement in DEFAULTS.get(name, {}).items():
            text = text.replace(field, replacement)
        parts.append(f"MSG: {name}\n{text}".strip() + "\n")
    return f"{SEPARATOR}\n".join(parts)


if __name__ == "__main__":
    TARGET.write_text(definitions(), encoding="utf-8", newline="\n")
