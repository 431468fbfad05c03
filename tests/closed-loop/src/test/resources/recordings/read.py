"""Reads a recording with rosbags and mcap-ros2-support, compares the results, and prints them as JSON."""

import dataclasses
import json
import sys
from pathlib import Path

import numpy
from mcap.reader import make_reader
from mcap.stream_reader import StreamReader
from mcap_ros2.decoder import DecoderFactory
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore


def same(one, other):
    """Return whether a value of rosbags equals one of mcap-ros2-support."""
    if dataclasses.is_dataclass(one):
        # Constants, in capitals, are fields of only one of the readers.
        names = [name for name in (field.name for field in dataclasses.fields(one)) if name != name.upper() and name[0] != "_"]
        return sorted(names) == sorted(other.__slots__) and all(same(getattr(one, n), getattr(other, n)) for n in names)
    if isinstance(one, numpy.ndarray):
        read = numpy.frombuffer(other, one.dtype) if isinstance(other, bytes) else numpy.array(other, one.dtype)
        return one.tobytes() == read.tobytes()
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    return one == other or (one != one and other != other)


def by_rosbags(path):
    """Return time, topic, bytes and value of each message."""
    store = get_typestore(Stores.EMPTY)
    with Reader(path) as reader:
        for connection in reader.connections:
            store.register(get_types_from_msg(connection.msgdef.data, connection.msgtype))
        found = [
            (time, connection.topic, connection.msgtype, bytes(data), store.deserialize_cdr(data, connection.msgtype))
            for connection, time, data in reader.messages()
        ]
        assert len(found) == reader.message_count, reader.message_count
    return found


def by_mcap(path):
    """Return the same from the reference reader, which verifies all checksums."""
    with path.open("rb") as file:
        list(StreamReader(file, validate_crcs=True, emit_chunks=False).records)
        file.seek(0)
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        found = [
            (each.message.log_time, each.channel.topic, each.schema.name, bytes(each.message.data), each.decoded_message)
            for each in reader.iter_decoded_messages()
        ]
        summary = reader.get_summary()
        assert summary.statistics.message_count == len(found), summary.statistics
        about = {record.name: record.metadata for record in reader.iter_metadata()}
    return found, about


def main(path):
    """Compare, and print."""
    ours, (theirs, about) = by_rosbags(path), by_mcap(path)
    order = [(each[0], each[1], each[3]) for each in theirs]
    assert sorted(each[:4] for each in ours) == sorted(each[:4] for each in theirs)
    values = {}
    for time, topic, _, data, value in ours:
        values[time, topic, data] = value
    for time, topic, _, data, value in theirs:
        assert same(values[time, topic, data], value), (time, topic)
    topics = {}
    for time, topic, type_name, data, value in theirs:
        known = topics.setdefault(topic, {"type": type_name, "times": [], "bytes": 0})
        known["times"].append(time)
        known["bytes"] += len(data)
        if topic == "/clock":
            assert value.clock.sec * 10**9 + value.clock.nanosec == time
        if topic == "/tf":
            known["frames"] = [[each.header.frame_id, each.child_frame_id] for each in value.transforms]
            known.setdefault("ego", []).append(value.transforms[0].transform.translation.x)
    assert len(order) == sum(len(topic["times"]) for topic in topics.values())
    print(json.dumps({"about": about.get("eventchain"), "topics": topics}))


main(Path(sys.argv[1]))
