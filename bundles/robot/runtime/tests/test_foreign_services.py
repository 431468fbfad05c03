"""Services between node files and programs written with Cyclone DDS's own Python package, which is not ours."""

from __future__ import annotations

import json
import struct
import threading
from pathlib import Path

import pytest
from conftest import FIXTURES
from eventchain_ros2.dds_entities import Participant
from eventchain_ros2.messages import Messages
from eventchain_ros2.service_peers import Matched
from node_processes import Running, World
from test_services import REQUEST, RESPONSE, SUM
from wire import EVERY, MILLISECOND, PATIENCE, SECOND, take, wait_until

HEADER, IDENTITY = 4, 16
SERVICES = FIXTURES / "services"
ANNOUNCED = pytest.mark.parametrize(
    "announced", [(), ("{role}=1.2.3;typehash=RIHS01_12;",)], ids=["without user data", "with that of ROS 2"]
)


@pytest.fixture
def node(world: World, tmp_path: Path) -> Starter:
    return Starter(world, tmp_path)


class Starter:
    """Starts the node files and the foreign programs of the service."""

    def __init__(self, world: World, folder: Path) -> None:
        self._world = world
        self._messages = folder / "messages.json"
        self._messages.write_text(json.dumps(SUM))

    def ours(self, name: str) -> Running:
        return self._world.run("--messages", self._messages, SERVICES / name)

    def foreign(self, role: str, announced: tuple[str, ...]) -> Running:
        key = "serviceid" if role == "server" else "clientid"
        return self._world.foreign(SERVICES / "foreign.py", role, *(each.format(role=key) for each in announced))


@ANNOUNCED
def test_a_foreign_client_is_answered(node: Starter, announced: tuple[str, ...]) -> None:
    server = node.ours("adder.py")
    client = node.foreign("client", announced)
    assert client.ends() == 0
    assert client.said == ["told True 1 9", "told True 2 18", "told True 3 27"]
    assert server.hears("asked 30 -3")
    assert not any("[WARN]" in line for line in server.said), server.said


@ANNOUNCED
def test_a_foreign_server_answers(node: Starter, announced: tuple[str, ...]) -> None:
    server = node.foreign("server", announced)
    client = node.ours("questions.py")
    assert client.hears("sum") == "sum 0"
    assert (client.hears("sum"), client.hears("sum")) == ("sum 1", "sum 2")
    assert client.ends() == 0
    assert not any("[WARN]" in line for line in client.said), client.said
    assert server.hears("asked 2")


def test_half_a_server_is_none(world: World, node: Starter) -> None:
    """The reader of one server and the writer of another one do not make a service."""
    participant = world.participant
    participant._catalog = Messages(SUM).catalog
    client = node.ours("questions.py")
    requests = participant.reader("rq/sumRequest", REQUEST, EVERY, "serviceid=1")
    replies = participant.writer("rr/sumReply", RESPONSE, EVERY, "serviceid=2")
    wait_until(lambda: requests.matched() and replies.matched(), "the client")
    (asker,), (answered,) = requests.peers(), replies.peers()
    assert asker.owner == answered.owner != ""
    client.hears("waits")  # may have begun before the match
    client.hears("waits")
    whole = participant.writer("rr/sumReply", RESPONSE, EVERY, "serviceid=1")
    taken = take(requests, 1)[0].data
    assert whole.matched()
    assert taken[HEADER + IDENTITY :] == struct.pack("<iiq", 0, 0, 2**62)
    whole.write(taken[: HEADER + IDENTITY] + struct.pack("<q", 2**62 + 5))
    assert client.hears("sum") == "sum 5"


@pytest.mark.parametrize("owner", ["", "clientid=1"])
def test_an_answer_waits_for_the_reader_of_its_client(
    participants: tuple[Participant, Participant], owner: str
) -> None:
    server, client = participants
    for participant in participants:
        participant._catalog = Messages(SUM).catalog
    taker, answers = (
        server.reader("rq/sumRequest", REQUEST, EVERY, "serviceid=1"),
        server.writer("rr/sumReply", RESPONSE, EVERY, "serviceid=1"),
    )
    asker = client.writer("rq/sumRequest", REQUEST, EVERY, owner)
    other = server.reader("rr/sumReply", RESPONSE, EVERY, "clientid=2")
    wait_until(lambda: taker.matched() and asker.matched() and answers.matched() and other.matched(), "a match")
    (peer,) = taker.peers()
    answering = threading.Thread(
        target=lambda: Matched({"reply": answers}, {"request": taker}, PATIENCE * SECOND).wait_for_client(
            "request", "reply", peer.handle
        )
    )
    answering.start()
    answering.join(0.1)
    assert answering.is_alive(), "only another client is known"
    client.reader("rr/sumReply", RESPONSE, EVERY, owner)
    answering.join(PATIENCE)
    assert not answering.is_alive()


def test_answers_do_not_wait_twice_for_a_client_without_a_reader(
    participants: tuple[Participant, Participant], monkeypatch: pytest.MonkeyPatch
) -> None:
    server, client = participants
    for participant in participants:
        participant._catalog = Messages(SUM).catalog
    taker, answers = server.reader("rq/sumRequest", REQUEST, EVERY), server.writer("rr/sumReply", RESPONSE, EVERY)
    asker = client.writer("rq/sumRequest", REQUEST, EVERY)
    wait_until(lambda: taker.matched() and asker.matched(), "a match")
    (peer,) = taker.peers()
    matched = Matched({"reply": answers}, {"request": taker}, MILLISECOND)
    matched.wait_for_client("request", "reply", 1)  # there is no such client any more
    matched.wait_for_client("request", "reply", peer.handle)
    monkeypatch.setattr(taker, "peer", lambda _: pytest.fail("it waits again"))
    matched.wait_for_client("request", "reply", peer.handle)


def test_answers_do_not_wait_for_a_client_that_goes_meanwhile(
    participants: tuple[Participant, Participant], monkeypatch: pytest.MonkeyPatch
) -> None:
    server, client = participants
    for participant in participants:
        participant._catalog = Messages(SUM).catalog
    taker, answers = server.reader("rq/sumRequest", REQUEST, EVERY), server.writer("rr/sumReply", RESPONSE, EVERY)
    asker = client.writer("rq/sumRequest", REQUEST, EVERY)
    wait_until(lambda: taker.matched() and asker.matched(), "a match")
    (peer,) = taker.peers()
    known = [peer, None, None]
    monkeypatch.setattr(taker, "peer", lambda _: known.pop(0))
    matched = Matched({"reply": answers}, {"request": taker}, SECOND)
    matched.wait_for_client("request", "reply", peer.handle)
    assert known == [None], "it waits for a client that is gone"
    matched.wait_for_client("request", "reply", peer.handle)
    assert known == [], "it has given the client up"
