"""Write the standard message definitions of ROS 2 as `messages` reads them.

`humble.msgs` has those of Humble, `jazzy.msgs` those that are new or different in Jazzy.

The definitions come from the type stores of `rosbags`. Run it after raising the pinned version of rosbags:
`python tools/extract_standard_messages.py`. A test of `messages` resolves them to `python/eventchain_ros2/humble.json`.
"""

from __future__ import annotations

from pathlib import Path

from rosbags.typesys import Stores, get_typestore

FOLDER = Path(__file__).parents[2] / "messages/src/main/resources/dev/eventchain/messages"
SEPARATOR = "=" * 80

# The type stores drop default values of fields. Only these are not zero (common_interfaces).
HUMBLE_DEFAULTS = {"geometry_msgs/msg/Quaternion": {"float64 w": "float64 w 1"}}
JAZZY_DEFAULTS = {**HUMBLE_DEFAULTS, "sensor_msgs/msg/NavSatStatus": {"int8 status": "int8 status -2"}}


def definitions(name: Stores, defaults: dict[str, dict[str, str]]) -> dict[str, str]:
    """Return the text of each definition by the name of its type."""
    store = get_typestore(name)
    texts = {}
    for type_name in sorted(store.fielddefs):
        text = store.generate_msgdef(type_name, ros_version=2)[0].split(SEPARATOR)[0].strip()
        for field, replacement in defaults.get(type_name, {}).items():
            text = text.replace(field, replacement)
        texts[type_name] = text
    return texts


def joined(texts: dict[str, str]) -> str:
    """Return definitions as one text, sorted by name, each under a `MSG: package/msg/Name` line."""
    return f"{SEPARATOR}\n".join(f"MSG: {name}\n{text}".strip() + "\n" for name, text in texts.items())


def files() -> dict[str, str]:
    """Return the content of both files by their names."""
    humble = definitions(Stores.ROS2_HUMBLE, HUMBLE_DEFAULTS)
    jazzy = definitions(Stores.ROS2_JAZZY, JAZZY_DEFAULTS)
    gone = humble.keys() - jazzy.keys()
    if gone:
        raise SystemExit(f"{gone} cannot be taken away by jazzy.msgs")
    other = {name: text for name, text in jazzy.items() if humble.get(name) != text}
    return {"humble.msgs": joined(humble), "jazzy.msgs": joined(other)}


if __name__ == "__main__":
    for file, content in files().items():
        (FOLDER / file).write_text(content, encoding="utf-8", newline="\n")
