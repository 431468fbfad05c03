"""Services of hosts on the wire, where each node is a process of its own."""

from __future__ import annotations

import json
import struct
from typing import Any

import pytest
from eventchain_ros2.dds_entities import Participant
from protocol import CONNECT, CONNECTED, MILLISECOND, PUBLISH, RUN, Failed
from test_node_host import FIXTURES, NodeProcess, tag  # noqa: F401 - a fixture
from wire import DOMAIN, EVERY, loopback_configuration, take, wait_until

REQUEST, RESPONSE = (f"example_interfaces/srv/AddTwoInts_{part}" for part in ("Request", "Response"))
CDR = b"\0\1\0\0"


def configuration(name: str) -> dict[str, Any]:
    node = {"module": "services.standard", "class": name, "name": name, "component": None, "execution_time_ms": 1.0}
    return {"path": [str(FIXTURES)], "messages": [], "nodes": [node]}


def connect(host: NodeProcess, *, writers: list[list[str]], readers: list[list[str]]) -> None:
    wanted = {"writers": writers, "turns": [(0, 1)] * len(writers), "readers": readers, "timeout_s": 60.0}
    host.send(CONNECT, json.dumps(wanted).encode())
    assert json.loads(host.receive(CONNECTED))["missing"] == []


def test_a_request_is_answered_at_its_simulated_time(tag: str) -> None:  # noqa: F811
    with NodeProcess(tag) as host, Participant(DOMAIN, loopback_configuration(tag)) as other:
        clock = other.writer("/clock", "rosgraph_msgs/msg/Clock", EVERY)
        requests, replies = other.writer("rq/sumRequest", REQUEST, EVERY), other.reader("rr/sumReply", RESPONSE, EVERY)
        ready = host.configure(configuration("Adder"))
        assert [(end["topic"], end["type"]) for end in ready["readers"]] == [("rq/sumRequest", REQUEST)]
        connect(host, writers=[[replies.guid.hex()]], readers=[[requests.guid.hex()]])
        for writer in (clock, requests):
            wait_until(writer.matched, writer.topic)
        clock.write(CDR + struct.pack("<iI", 0, 0))
        host.let(PUBLISH, 0)
        requests.write(CDR + struct.pack("<Qqqq", 2**63, 5, 40, 2), 1)
        assert host.idle()["samples"]
        assert host.let(RUN, 0)["next"] == [MILLISECOND, False], "the answer is seen then"
        clock.write(CDR + struct.pack("<iI", 0, MILLISECOND))
        assert host.let(PUBLISH, MILLISECOND)["wrote"] == [1]
        (reply,) = take(replies, 1)
        assert (reply.source_timestamp, reply.data) == (MILLISECOND, CDR + struct.pack("<Qqq", 2**63, 5, 42))
        log = host.finish()
        ((_, _, _, reads, writes),) = log["nodes"][0]["activations"]
        assert (reads, writes) == ([["rq/sumRequest", 1]], [["rr/sumReply", MILLISECOND]])


def test_a_service_that_nobody_offers_is_an_error_when_time_begins(tag: str) -> None:  # noqa: F811
    with NodeProcess(tag) as host, Participant(DOMAIN, loopback_configuration(tag)) as other:
        clock = other.writer("/clock", "rosgraph_msgs/msg/Clock", EVERY)
        host.configure(configuration("Asker"))
        connect(host, writers=[[]], readers=[[]])
        wait_until(clock.matched, "its clock")
        clock.write(CDR + struct.pack("<iI", 0, 0))
        with pytest.raises(Failed, match="node 'Asker' waits for the service '/sum', but none of the nodes"):
            host.let(PUBLISH, 0)
