"""Random messages of rosbags, an independent implementation."""

from __future__ import annotations

import random
import string
from typing import Any

import numpy as np
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore

STORE = get_typestore(Stores.ROS2_HUMBLE)
PLACEHOLDER = "structure_needs_at_least_one_member"


def random_value(description: Any, generator: random.Random) -> Any:
    kind, detail = description
    if kind == Nodetype.NAME:
        return random_message(detail, generator)
    if kind == Nodetype.BASE:
        return random_primitive(detail[0], generator, detail[1])
    element, bound = detail
    count = bound if kind == Nodetype.ARRAY else generator.randrange(min(bound or 4, 4) + 1)
    values = [random_value(element, generator) for _ in range(count)]
    if element[0] == Nodetype.BASE and element[1][0] != "string":
        return np.array(
            values, dtype=np.dtype({"bool": "?", "byte": "u1", "char": "u1"}.get(element[1][0], element[1][0]))
        )
    return values


def random_primitive(base: str, generator: random.Random, bound: int) -> Any:
    if base == "string":
        return "".join(generator.choices(string.ascii_letters + "äß€", k=generator.randrange(bound or 8) // 3))
    if base == "bool":
        return generator.random() < 0.5
    if base.startswith("float"):
        return float(np.float32(generator.choice([generator.uniform(-1e6, 1e6), float("inf"), 0.0])))
    if base in ("byte", "char"):
        return generator.randrange(128)  # a byte in rosbags is an int8
    bits = int(base.lstrip("uint"))
    low = 0 if base.startswith("u") else -(2 ** (bits - 1))
    return generator.randrange(low, low + 2**bits)


def random_message(name: str, generator: random.Random) -> Any:
    values = {field: random_value(description, generator) for field, description in STORE.fielddefs[name][1]}
    if PLACEHOLDER in values:
        values[PLACEHOLDER] = 0
    return STORE.types[name](**values)
