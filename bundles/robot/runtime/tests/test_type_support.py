"""Type hashes compared with rosbags, and the graph's message with its definition."""

from __future__ import annotations

import pytest
from eventchain_ros2 import graph
from eventchain_ros2.catalog import Catalog
from eventchain_ros2.definitions import Definition, resolved
from eventchain_ros2.graph import GraphNode
from eventchain_ros2.type_support import dds_type_name, type_hash
from instances import STORE
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

CATALOG = Catalog()
HUMBLE, IRON = 24, 16
NODES = [
    GraphNode("talker", "/", b"p" * 16, (b"w" * 16, b"x" * 16), ()),
    GraphNode("listener", "/room", b"p" * 16, (), (b"r" * 16,)),
]


def defined(name: str) -> Definition:
    found = CATALOG.find(name)
    assert found is not None
    return found


def has_char(name: str) -> bool:
    bases = [field.type.base for field in defined(name).fields]
    return "char" in bases or any(has_char(base) for base in bases if "/" in base)


PLAIN = [name for name in CATALOG.names() if not has_char(name)]


def test_hardly_any_type_has_characters() -> None:
    assert len(PLAIN) > 140
    assert "rmw_dds_common/msg/Gid" not in PLAIN


@pytest.mark.parametrize("name", PLAIN)
def test_the_hash_is_that_of_rosbags(name: str) -> None:
    assert type_hash(name, defined) == STORE.hash_rihs01(name)


def test_the_hash_is_that_which_ros_publishes() -> None:
    known = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
    assert type_hash("std_msgs/msg/String", defined) == known


@pytest.mark.parametrize("kind", ["", "[4]", "[]", "[<=4]"])
def test_a_char_is_hashed_as_the_uint8_that_ros_makes_of_it(kind: str) -> None:
    text = "char{} letter\nstring<=5[2] words\nfloat64[<=3] numbers\nbyte octet"
    fields = [line.split()[::-1] for line in text.format(kind).splitlines()]
    own = resolved("own_msgs/msg/Own", {"fields": fields, "constants": []})
    store = get_typestore(Stores.ROS2_HUMBLE)
    store.register(get_types_from_msg(text.format(kind).replace("char", "uint8"), "own_msgs/msg/Own"))
    assert type_hash("own_msgs/msg/Own", {"own_msgs/msg/Own": own}.__getitem__) == store.hash_rihs01("own_msgs/msg/Own")


def test_the_name_on_the_wire_is_that_of_ros() -> None:
    assert dds_type_name("sensor_msgs/msg/LaserScan") == "sensor_msgs::msg::dds_::LaserScan_"


@pytest.mark.parametrize("size", [HUMBLE, IRON])
def test_the_graph_is_written_as_its_definition_says(size: int) -> None:
    store = get_typestore(Stores.ROS2_HUMBLE if size == HUMBLE else Stores.ROS2_IRON)
    data = graph.encode(b"p" * 16, NODES, size)
    theirs = store.deserialize_cdr(data, graph.TYPE)
    assert bytes(theirs.gid.data) == (b"p" * 16).ljust(size, b"\0")
    assert [each.node_name for each in theirs.node_entities_info_seq] == ["talker", "listener"]
    assert [len(each.writer_gid_seq) for each in theirs.node_entities_info_seq] == [2, 0]
    assert bytes(store.serialize_cdr(theirs, graph.TYPE)) == data
    assert graph.decode(data, size) == NODES
    assert graph.decode(bytes(store.serialize_cdr(theirs, graph.TYPE, little_endian=False)), size) == NODES


def test_a_graph_cut_short_is_refused_at_every_length() -> None:
    data = graph.encode(b"p" * 16, NODES, IRON)
    for length in range(4, len(data)):
        with pytest.raises(ValueError, match="no rmw_dds_common"):
            graph.decode(data[:length], IRON)


@pytest.mark.parametrize(("distribution", "size"), [("humble", 24), ("iron", 16), ("jazzy", 16), (None, 16)])
def test_the_size_of_identifiers_depends_on_the_distribution(
    monkeypatch: pytest.MonkeyPatch, distribution: str | None, size: int
) -> None:
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    if distribution:
        monkeypatch.setenv("ROS_DISTRO", distribution)
    assert graph.gid_size() == size
