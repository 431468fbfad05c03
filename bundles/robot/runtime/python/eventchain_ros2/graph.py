"""The ROS graph on the wire: the nodes of a participant, as `rmw_dds_common/msg/ParticipantEntitiesInfo`.

ROS 2 publishes it on the topic `ros_discovery_info`; `ros2 node list` and `rqt_graph` read it.
"""

from __future__ import annotations

import os
import struct
from typing import NamedTuple

from eventchain_ros2.definitions import Definition, resolved

TOPIC = "ros_discovery_info"
TYPE = "rmw_dds_common/msg/ParticipantEntitiesInfo"
GUID_SIZE = 16
_HUMBLE_SIZE = 24
_BEFORE_IRON = ("foxy", "galactic", "humble")
_NAME_BOUND = 256


class GraphNode(NamedTuple):
    """A node: its name and namespace, the GUID of its participant and those of its writers and readers (16 bytes)."""

    name: str
    namespace: str
    participant: bytes
    writers: tuple[bytes, ...]
    readers: tuple[bytes, ...]


def gid_size() -> int:
    """Return the size of a GUID in ROS 2 in bytes: 24 until Humble, 16 from Iron on, according to `ROS_DISTRO`."""
    return _HUMBLE_SIZE if os.environ.get("ROS_DISTRO") in _BEFORE_IRON else GUID_SIZE


def definitions(size: int) -> list[Definition]:
    """The definitions of the message and of what it contains, for GUIDs of this size."""
    gid, node = "rmw_dds_common/msg/Gid", "rmw_dds_common/msg/NodeEntitiesInfo"
    text, gids = f"string<={_NAME_BOUND}", f"{gid}[]"
    fields = {
        gid: [["data", f"char[{size}]"]],
        node: [["node_namespace", text], ["node_name", text], ["reader_gid_seq", gids], ["writer_gid_seq", gids]],
        TYPE: [["gid", gid], ["node_entities_info_seq", f"{node}[]"]],
    }
    return [resolved(name, {"fields": each, "constants": []}) for name, each in fields.items()]


def encode(participant: bytes, nodes: list[GraphNode], size: int) -> bytes:
    """Encode the message as CDR, for GUIDs of this size."""
    data = bytearray(b"\x00\x01\x00\x00" + participant.ljust(size, b"\0"))
    _append_length(data, len(nodes))
    for node in nodes:
        for text in (node.namespace, node.name):
            encoded = text.encode() + b"\0"
            _append_length(data, len(encoded))
            data += encoded
        for guids in (node.readers, node.writers):
            _append_length(data, len(guids))
            data += b"".join(guid.ljust(size, b"\0") for guid in guids)
    return bytes(data)


def _append_length(data: bytearray, length: int) -> None:
    data += bytes(-len(data) % 4) + struct.pack("<I", length)


def decode(data: bytes, size: int) -> list[GraphNode]:
    """Return the nodes of a message that was checked against its type.

    Raises:
        ValueError: it is not such a message.

    """
    try:
        return _Reader(data, size).nodes()
    except (struct.error, UnicodeDecodeError) as problem:
        raise ValueError(f"no {TYPE}: {problem}") from problem


class _Reader:
    def __init__(self, data: bytes, size: int) -> None:
        self._data = data
        self._position = 4
        self._size = size
        self._order = "<I" if data[1] & 1 else ">I"

    def nodes(self) -> list[GraphNode]:
        participant = self._guid()
        return [self._node(participant) for _ in range(self._length())]

    def _node(self, participant: bytes) -> GraphNode:
        namespace, name = self._text(), self._text()
        readers = tuple(self._guid() for _ in range(self._length()))
        writers = tuple(self._guid() for _ in range(self._length()))
        return GraphNode(name, namespace, participant, writers, readers)

    def _length(self) -> int:
        self._position += -self._position % 4
        (length,) = struct.unpack_from(self._order, self._data, self._position)
        self._position += 4
        if length > len(self._data):
            raise ValueError(f"no {TYPE}: it ends before its {length} elements")
        return int(length)

    def _text(self) -> str:
        return self._bytes(self._length())[:-1].decode()

    def _guid(self) -> bytes:
        return self._bytes(self._size)[:GUID_SIZE]

    def _bytes(self, count: int) -> bytes:
        start, self._position = self._position, self._position + count
        if self._position > len(self._data):
            raise ValueError(f"no {TYPE}: {self._position - len(self._data)} bytes are missing")
        return self._data[start : self._position]
