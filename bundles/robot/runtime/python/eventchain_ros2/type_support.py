"""DDS and ROS 2 data of a message type: the topic descriptor, its name on the wire, and its hash.

Descriptors are created with the dynamic-type API from the same definitions as the message classes. They have no type
information: with it Cyclone DDS compares types by structure and refuses those of ROS 2, which have none.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from eventchain_ros2 import cyclone
from eventchain_ros2.cyclone import LayoutError, checked
from eventchain_ros2.definitions import Definition, Field, FieldType

Lookup = Callable[[str], Definition]
"""Gives the definition of a type by its full name; raises `KeyError` if there is none."""

PLACEHOLDER = Field("structure_needs_at_least_one_member", FieldType("uint8", "scalar", 0, 0), None)
"""The only field of a message that has none (rosidl)."""

IDENTITY = [
    Field("rmw_client", FieldType("uint64", "scalar", 0, 0), None),
    Field("rmw_request", FieldType("int64", "scalar", 0, 0), None),
]
"""Header before the fields of requests and responses on the wire (rmw_cyclonedds)."""

_PRIMITIVE, _DEFINITION = 2, 1
_STRING, _ARRAY, _SEQUENCE, _STRUCTURE = 16, 21, 22, 24
_KINDS = {"bool": 1, "int16": 3, "int32": 4, "int64": 5, "uint16": 6, "uint32": 7, "uint64": 8, "float32": 9}
_KINDS.update({"float64": 10, "int8": 12, "uint8": 13, "byte": 13, "char": 13})
_FINAL = 0
_AT_THE_END = 0xFFFFFFFF
_LOCAL_DOMAIN = 1
_HAS_TYPE_INFORMATION = 1 << 6
_LONGEST_WAIT = 1_000_000_000  # ns; the type is local, so no wait is needed

# type_description_interfaces/msg/FieldType
_NESTED, _TYPE_STRING, _TYPE_BOUNDED_STRING = 1, 17, 21
_TYPE_IDS = {"int8": 2, "uint8": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7, "int64": 8, "uint64": 9}
_TYPE_IDS.update({"float32": 10, "float64": 11, "bool": 15, "byte": 16, "string": _TYPE_STRING})
_TYPE_IDS["char"] = _TYPE_IDS["uint8"]  # name of the type in ROS 2
_ARRAYS, _BOUNDED_SEQUENCES, _SEQUENCES = 48, 96, 144


def dds_type_name(name: str) -> str:
    """Return the DDS name of a message type: `sensor_msgs::msg::dds_::LaserScan_`."""
    package, kind, short_name = name.split("/")
    return f"{package}::{kind}::dds_::{short_name}_"


def fields_on_the_wire(definition: Definition) -> list[Field]:
    """Return the fields of a message as encoded; there is at least one."""
    return definition.fields or [PLACEHOLDER]


def is_of_service(name: str) -> bool:
    """Return whether a message type is a request or response."""
    return "/srv/" in name


def with_identity(definition: Definition) -> Definition:
    """Return a request or response as it is on the wire of Cyclone DDS: behind its client and number."""
    return definition._replace(fields=[*IDENTITY, *fields_on_the_wire(definition)])


def type_hash(name: str, lookup: Lookup) -> str:
    """Return the hash of a message type, `RIHS01_` and 64 hexadecimal digits (REP 2016)."""
    described: dict[str, dict[str, Any]] = {}
    _describe(name, lookup, described)
    text = json.dumps(
        {
            "type_description": described.pop(name),
            "referenced_type_descriptions": [described[each] for each in sorted(described)],
        }
    )
    return "RIHS01_" + hashlib.sha256(text.encode()).hexdigest()


def _describe(name: str, lookup: Lookup, described: dict[str, dict[str, Any]]) -> None:
    if name in described:
        return
    fields = fields_on_the_wire(lookup(name))
    described[name] = {
        "type_name": name,
        "fields": [{"name": field.name, "type": _describe_type(field.type)} for field in fields],
    }
    for field in fields:
        if field.type.base not in _TYPE_IDS:
            _describe(field.type.base, lookup, described)


def _describe_type(field_type: FieldType) -> dict[str, Any]:
    offset = {"scalar": 0, "array": _ARRAYS, "sequence": _BOUNDED_SEQUENCES if field_type.size else _SEQUENCES}
    type_id = _TYPE_BOUNDED_STRING if field_type.string_bound else _TYPE_IDS.get(field_type.base, _NESTED)
    return {
        "type_id": offset[field_type.kind] + type_id,
        "capacity": field_type.size,
        "string_capacity": field_type.string_bound,
        "nested_type_name": "" if field_type.base in _TYPE_IDS else field_type.base,
    }


@contextmanager
def descriptor(participant: int, name: str, lookup: Lookup) -> Iterator[Any]:
    """Provide a pointer to the `dds_topic_descriptor_t` of a message type, for the length of the block.

    Args:
        participant: the entity that owns the type.
        name: full name of the message type.
        lookup: definitions of this type and of its nested types.

    Raises:
        KeyError: a type is not defined.
        DdsError: Cyclone DDS refuses the type.
        LayoutError: the library has another memory layout.

    """
    library = cyclone.load()
    made = ctypes.POINTER(cyclone.TopicDescriptor)()
    structure = _structure(participant, name, lookup)
    information = ctypes.c_void_p()
    try:
        checked(library.dds_dynamic_type_register(structure, information), f"type {name}")
        code = library.dds_create_topic_descriptor(_LOCAL_DOMAIN, participant, information, _LONGEST_WAIT, made)
        checked(code, f"type {name}")
    finally:
        library.dds_free_typeinfo(information)
        library.dds_dynamic_type_unref(structure)
    try:
        _remove_type_information(made[0], name)
        yield made
    finally:
        library.dds_delete_topic_descriptor(made)


def _remove_type_information(made: Any, name: str) -> None:
    blobs = [made.type_information, made.type_mapping]
    if made.type_name.decode() != dds_type_name(name) or made.number_of_keys or not made.number_of_operations:
        raise LayoutError("the descriptor of a topic has other fields")
    if not made.flags & _HAS_TYPE_INFORMATION or not all(blob.data and 0 < blob.size < 1 << 24 for blob in blobs):
        raise LayoutError("the type information is elsewhere in the descriptor of a topic")
    made.flags &= ~_HAS_TYPE_INFORMATION
    for blob in blobs:
        cyclone.load().dds_free(blob.data)
        blob.data, blob.size = None, 0


def _structure(participant: int, name: str, lookup: Lookup) -> cyclone.DynamicType:
    library = cyclone.load()
    wire_name = dds_type_name(name).encode()
    structure = _create(participant, cyclone.TypeDescriptor(kind=_STRUCTURE, name=wire_name), name)
    checked(library.dds_dynamic_type_set_extensibility(structure, _FINAL), name)
    for index, field in enumerate(fields_on_the_wire(lookup(name))):
        # From here on, added types belong to the structure.
        member = cyclone.MemberDescriptor(
            name=field.name.encode(), id=index, type=_spec(participant, field.type, lookup), index=_AT_THE_END
        )
        checked(library.dds_dynamic_type_add_member(structure, member), f"{name}.{field.name}")
    return structure


def _spec(participant: int, field_type: FieldType, lookup: Lookup) -> cyclone.TypeSpec:
    element = _element(participant, field_type, lookup)
    if field_type.kind == "scalar":
        return element
    kind = _ARRAY if field_type.kind == "array" else _SEQUENCE
    collection = cyclone.TypeDescriptor(kind=kind, name=b"collection", element_type=element)
    return _defined(_create(participant, _bounded(collection, field_type.size), field_type.base))


def _element(participant: int, field_type: FieldType, lookup: Lookup) -> cyclone.TypeSpec:
    base = field_type.base
    if base in _KINDS:
        spec = cyclone.TypeSpec(kind=_PRIMITIVE)
        spec.type.opaque[0] = _KINDS[base]
        return spec
    if base == "string":
        text = _bounded(cyclone.TypeDescriptor(kind=_STRING), field_type.string_bound)
        return _defined(_create(participant, text, base))
    return _defined(_structure(participant, base, lookup))


def _bounded(described: cyclone.TypeDescriptor, bound: int) -> cyclone.TypeDescriptor:
    if bound:
        described.number_of_bounds = 1
        described.bounds = (ctypes.c_uint32 * 1)(bound)
    return described


def _create(participant: int, described: cyclone.TypeDescriptor, what: str) -> cyclone.DynamicType:
    made: cyclone.DynamicType = cyclone.load().dds_dynamic_type_create(participant, described)
    checked(made.code, f"type {what}")
    return made


def _defined(made: cyclone.DynamicType) -> cyclone.TypeSpec:
    return cyclone.TypeSpec(kind=_DEFINITION, type=made)
