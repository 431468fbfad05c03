"""Write random messages of types as rosbags serializes them: `random_messages.py [--jazzy] FILE FOLDER [TYPE...]`.

The types are the named ones, or all: the standard ones and those of the folder. The standard ones are those of ROS 2
Humble, or of Jazzy.

One JSON object a line: `type`, its `hash`, `cdr` and `cdr_big_endian` (hexadecimal), and `value` as nested lists and
objects. Floating-point numbers stand as text, so that infinities and NaN survive.
"""

from __future__ import annotations

import json
import random
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_types_from_idl, get_types_from_msg, get_typestore

INSTANCES = 5
MAXIMAL_LENGTH = 5
STRINGS = ("", "a", "frame_id", "größer als null", "\U0001f697" * 3, "x" * 300)
FLOATS = (0.0, -0.0, 1.5, -3.25e10, 1e-30, float("inf"), float("-inf"), float("nan"))
NOTHING = "structure_needs_at_least_one_member"  # what a message without fields has on the wire

JAZZY = "--jazzy"

store = get_typestore(Stores.ROS2_JAZZY if JAZZY in sys.argv else Stores.ROS2_HUMBLE)
chance = random.Random(20261121)


def message(name: str) -> Any:
    """A random message of a type."""
    fields = store.fielddefs[name][1]
    return store.types[name](**{field: 0 if field == NOTHING else value(description) for field, description in fields})


def value(description: Any) -> Any:
    """A random value of a field."""
    kind, details = description
    if kind == Nodetype.NAME:
        return message(details)
    if kind == Nodetype.BASE:
        return number(*details)
    element, size = details
    if kind == Nodetype.SEQUENCE:
        size = chance.randint(0, min(size, MAXIMAL_LENGTH) if size else MAXIMAL_LENGTH)
    values = [value(element) for _ in range(size)]
    if element[0] == Nodetype.BASE and element[1][0] != "string":
        return np.array(values, dtype=numpy_type(element[1][0]))
    return values


def number(base: str, bound: int) -> Any:
    """A random value of a primitive type."""
    if base == "string":
        return chance.choice([text for text in STRINGS if not bound or len(text) <= bound // 4])
    if base == "bool":
        return chance.random() < 0.5
    if base.startswith("float"):
        return float(np.float32(chance.choice((*FLOATS, chance.gauss(0, 100)))))
    if base == "byte":
        return chance.randint(0, 127)  # an octet, which rosbags takes for signed
    info = np.iinfo(numpy_type(base))
    return chance.choice((0, 1, int(info.min), int(info.max), chance.randint(int(info.min), int(info.max))))


def numpy_type(base: str) -> Any:
    """The element type of an array of a primitive type."""
    return np.dtype({"byte": "uint8", "char": "uint8"}.get(base, base))


def plain(item: Any) -> Any:
    """The same as JSON can hold it."""
    if hasattr(item, "__msgtype__"):
        names = [field for field, _ in store.fielddefs[item.__msgtype__][1]]
        return {name: plain(getattr(item, name)) for name in names if name != NOTHING}
    if isinstance(item, np.ndarray):
        return [plain(element) for element in item.tolist()]
    if isinstance(item, list):
        return [plain(element) for element in item]
    return repr(item) if isinstance(item, float) else item


def register(folder: Path) -> None:
    """Let rosbags know the definitions of a folder, as far as it can read them.

    In IDL it takes no comment between includes. In the message language it does not read all values, which change
    nothing on the wire, and takes `char` for another type than ROS 2 does, which is not what is compared here.
    """
    for file in sorted(folder.glob("*/msg/*.msg")):
        lines = file.read_text(encoding="utf-8").splitlines()
        fields = [" ".join(line.split()[:2]) for line in lines if "=" not in line.split("<=")[-1] and line[:1] != "#"]
        text = re.sub("^char", "uint8", "\n".join(fields), flags=re.MULTILINE)
        store.register(get_types_from_msg(text, f"{file.parent.parent.name}/msg/{file.stem}"))
    for file in sorted(folder.glob("*/msg/*.idl")):
        lines = file.read_text(encoding="utf-8").splitlines()
        store.register(get_types_from_idl("\n".join(line for line in lines if not line.startswith("#include"))))


def main(target: Path, names: list[str]) -> None:
    """Write the file."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with target.open("w", encoding="utf-8", newline="\n") as file:
        for name in names or sorted(store.fielddefs):
            for _ in range(INSTANCES):
                made = message(name)
                line = {
                    "type": name,
                    "hash": store.hash_rihs01(name),
                    "cdr": bytes(store.serialize_cdr(made, name, little_endian=True)).hex(),
                    "cdr_big_endian": bytes(store.serialize_cdr(made, name, little_endian=False)).hex(),
                    "value": plain(made),
                }
                file.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    file, definitions, *types = [argument for argument in sys.argv[1:] if argument != JAZZY]
    register(Path(definitions))
    main(Path(file), types)
