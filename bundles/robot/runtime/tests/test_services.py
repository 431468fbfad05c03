"""Services: in lock-step, in records, and on DDS."""

from __future__ import annotations

import importlib
import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import rclpy
from eventchain_ros2 import catalog, context
from eventchain_ros2.dds_entities import Participant
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.simulation import Simulation
from node_processes import World
from protocol import MILLISECOND, Failed, HostProcess
from rclpy.exceptions import InvalidServiceNameException
from rclpy.node import Node
from rclpy.service_introspection import ServiceIntrospectionState
from wire import EVERY, take, wait_until

FIXTURES = Path(__file__).with_name("fixtures")
STANDARD = json.loads(catalog.STANDARD_SERVICES.read_text())
SUM = {
    "demo_srvs/srv/Sum_Request": {"fields": [["a", "int32"], ["b", "int64"]], "constants": []},
    "demo_srvs/srv/Sum_Response": {"fields": [["sum", "int64"]], "constants": []},
    "demo_srvs/srv/Nothing_Request": {"fields": [], "constants": []},
    "demo_srvs/srv/Nothing_Response": {"fields": [], "constants": []},
}
REQUEST, RESPONSE = "demo_srvs/srv/Sum_Request", "demo_srvs/srv/Sum_Response"


@pytest.fixture
def services() -> Any:
    messages = Messages(SUM)
    messages.install()
    context.enter(Simulation())
    import demo_srvs.srv  # type: ignore[import-not-found]

    yield demo_srvs.srv
    context.current().running = False


def adding(sum_type: Any) -> Node:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node = Node("adder")
    node.create_service(sum_type, "sum", add)
    return node


def test_a_request_is_answered(services: Any) -> None:
    server, client_node = adding(services.Sum), Node("asker")
    client = client_node.create_client(services.Sum, "/sum")
    assert client.service_is_ready()
    futures = [client.call_async(services.Sum.Request(a=number, b=5)) for number in (1, 2)]
    for _ in range(2):
        rclpy.spin_once(server, timeout_sec=1.0)
    rclpy.spin_until_future_complete(client_node, futures[1], timeout_sec=1.0)
    assert [future.result().sum for future in futures] == [6, 7]
    assert server.get_service_names_and_types() == [("/sum", ["demo_srvs/srv/Sum"])]
    assert server.get_service_names_and_types_by_node("adder", "/") == [("/sum", ["demo_srvs/srv/Sum"])]
    assert server.get_client_names_and_types_by_node("asker", "/") == [("/sum", ["demo_srvs/srv/Sum"])]
    assert (server.count_services("sum"), server.count_clients("/sum")) == (1, 1)
    assert server.get_topic_names_and_types() == [], "the topics of services are no topics of ROS 2"
    assert client_node.destroy_client(client)
    assert (server.count_clients("sum"), len(server.services)) == (0, 1)


def test_clients_of_one_service_get_their_own_answers(services: Any) -> None:
    server, asker = adding(services.Sum), Node("asker")
    one, two = (asker.create_client(services.Sum, "sum") for _ in range(2))
    first, second = one.call_async(services.Sum.Request(a=1)), two.call_async(services.Sum.Request(a=2))
    forgotten = two.call_async(services.Sum.Request(a=3))
    two.remove_pending_request(forgotten)
    context.current().advance(MILLISECOND)
    assert (first.result().sum, second.result().sum, forgotten.done()) == (1, 2, False)
    assert server.services[0].srv_name == "/sum"


def test_coroutines_ask_and_answer(services: Any) -> None:
    heard: list[int] = []

    class Asker(Node):
        def __init__(self) -> None:
            super().__init__("asker")
            self.client = self.create_client(services.Sum, "sum")
            self.create_service(services.Sum, "twice", self.twice)
            self.create_timer(0.1, self.ask)

        async def twice(self, request: Any, response: Any) -> Any:
            response.sum = (await self.client.call_async(request)).sum * 2
            return response

        async def ask(self) -> None:
            twice = self.create_client(services.Sum, "twice")
            heard.append((await twice.call_async(services.Sum.Request(a=1, b=2))).sum)

    adding(services.Sum)
    Asker()
    context.current().advance(150 * MILLISECOND)
    assert heard == [6]


@pytest.mark.parametrize(
    ("misuse", "error"),
    [
        (lambda client, types: client.call_async(types.Nothing.Request()), TypeError),
        (lambda client, types: Node("other").create_client(types.Sum, "1st"), InvalidServiceNameException),
        (lambda client, types: client.call(types.Sum.Request()), RuntimeError),
        (lambda client, types: client.call_async(types.Sum.Request(a=1.5)), AssertionError),
        (
            lambda client, types: client.configure_introspection(None, None, ServiceIntrospectionState(1)),
            NotImplementedError,
        ),
    ],
)
def test_misuse_is_an_error(services: Any, misuse: Callable[[Any, Any], Any], error: type[Exception]) -> None:
    with pytest.raises(error):
        misuse(Node("asker").create_client(services.Sum, "sum"), services)


def test_an_answer_of_another_type_is_an_error(services: Any) -> None:
    node = Node("server")
    node.create_service(services.Sum, "sum", lambda request, response: None)
    node.create_client(services.Sum, "sum").call_async(services.Sum.Request())
    with pytest.raises(TypeError, match=r"Expected .*Sum_Response"):
        context.current().advance(MILLISECOND)


def test_a_service_is_waited_for_outside_of_callbacks(services: Any) -> None:
    client = Node("asker").create_client(services.Sum, "sum")
    assert not client.wait_for_service(timeout_sec=0.5)
    assert context.current().now == 500 * MILLISECOND
    with pytest.raises(RuntimeError, match="nothing will ever happen"):
        client.wait_for_service()
    adding(services.Sum)
    assert client.wait_for_service()


def test_packages_list_their_services(services: Any) -> None:
    names: dict[str, Any] = {}
    exec("from demo_srvs.srv import *", names)
    assert {"Sum", "Nothing"} <= set(names)
    assert names["Sum"].Request.get_fields_and_field_types() == {"a": "int32", "b": "int64"}
    with pytest.raises(AttributeError, match="has no service 'Difference'"):
        services.Difference  # noqa: B018


def configuration(tmp_path: Path, *nodes: tuple[str, float]) -> dict[str, Any]:
    file = tmp_path / "messages.json"
    file.write_text(json.dumps(SUM))
    return {
        "path": [str(FIXTURES)],
        "messages": [str(file)],
        "nodes": [
            {
                "module": "services.nodes",
                "class": name,
                "name": name.lower(),
                "component": None,
                "execution_time_ms": time,
                "phase_ms": 0.0,
            }
            for name, time in nodes
        ],
        "world_subscribes": [
            {"topic": "rq/sumRequest", "type": REQUEST},
            {"topic": "rr/sumReply", "type": RESPONSE},
            {"topic": "/heard", "type": "std_msgs/msg/Int64"},
        ],
    }


def test_in_lock_step_requests_and_answers_are_in_the_record(tmp_path: Path) -> None:
    with HostProcess() as host:
        ready = host.configure(configuration(tmp_path, ("Asker", 1.0), ("Adder", 2.0)))
        topics = {topic["topic"]: topic for topic in ready["topics"]}
        assert topics["rq/sumRequest"]["publishers"] == [["asker", REQUEST]]
        assert ["adder", REQUEST] in topics["rq/sumRequest"]["subscriptions"]
        samples = host.step(150 * MILLISECOND)
        assert [(time / MILLISECOND, index) for time, index, _ in samples] == [(101.0, 0), (103.0, 1), (104.0, 2)]
        identity = samples[0][2][4:20]
        assert samples[0][2] == b"\0\1\0\0" + identity + struct.pack("<ixxxxq", 1, 2)
        assert samples[1][2] == b"\0\1\0\0" + identity + struct.pack("<q", 3)
        log = host.finish()
        asker, adder = log["nodes"]
        assert [activation[:2] for activation in asker["activations"]] == [
            [100 * MILLISECOND, 101 * MILLISECOND],
            [103 * MILLISECOND, 104 * MILLISECOND],
        ]
        ((_, _, _, reads, writes),) = adder["activations"]
        assert (reads, writes) == ([["rq/sumRequest", 0]], [["rr/sumReply", 0]])
        assert log["publications"]["rr/sumReply"] == [[0, 103 * MILLISECOND]]


def test_a_service_that_no_node_offers_is_an_error_at_the_start(tmp_path: Path) -> None:
    with HostProcess() as host, pytest.raises(Failed) as failed:
        host.configure(configuration(tmp_path, ("Asker", 1.0)))
    assert (failed.value.details["id"], failed.value.details["node"]) == ("node.failed", "asker")
    assert "node 'asker' waits for the service '/sum', but none" in failed.value.details["message"]


def test_on_dds_the_form_is_that_of_cyclone(participants: tuple[Participant, Participant]) -> None:
    one, other = participants
    for participant in participants:
        participant._catalog = Messages(SUM).catalog
    writer, reader = one.writer("rq/sumRequest", REQUEST, EVERY), other.reader("rq/sumRequest", REQUEST, EVERY)
    wait_until(writer.matched, "the server")
    assert [peer.type_name for peer in writer.peers()] == ["demo_srvs::srv::dds_::Sum_Request_"]
    assert reader.announced.topic == "rq/sumRequest"
    sample = b"\0\1\0\0" + struct.pack("<Qqixxxxq", 7, 1, 2, 3)
    writer.write(sample)
    assert [each.data for each in take(reader, 1)] == [sample]
    empty = "demo_srvs/srv/Nothing_Request"
    writer, reader = one.writer("rq/noRequest", empty, EVERY), other.reader("rq/noRequest", empty, EVERY)
    wait_until(writer.matched, "the server")
    writer.write(b"\0\1\0\0" + struct.pack("<QqB", 7, 1, 0))
    assert len(take(reader, 1)) == 1


def test_node_files_ask_each_other_on_dds(world: World, tmp_path: Path) -> None:
    file = tmp_path / "messages.json"
    file.write_text(json.dumps(SUM))
    adder = world.run("--messages", file, FIXTURES / "services" / "adder.py")
    asker = world.run("--messages", file, FIXTURES / "services" / "asker.py", "20", "22")
    asker.hears("waited")
    assert asker.hears("sum") == "sum 42"
    assert asker.hears("graph") == "graph [('/sum', ['demo_srvs/srv/Sum'])] True"
    assert asker.hears("call") == "call 44"
    assert asker.ends() == 0
    adder.hears("asked 20 22")


@pytest.mark.parametrize("package", ["std_srvs", "example_interfaces"])
def test_standard_services_are_there(messages: Messages, package: str) -> None:
    module = importlib.import_module(f"{package}.srv")
    assert module.SetBool.Request(data=True).data
    assert module.Trigger.Response.get_fields_and_field_types() == {"success": "boolean", "message": "string"}
    assert {"SetBool", "Trigger"} <= set(module.__all__)


def test_every_standard_service_is_encoded(messages: Messages) -> None:
    names = [name for name in STANDARD if "/srv/" in name]
    assert len(names) == 48
    for name in STANDARD:
        message = messages.get(name)()
        assert from_cdr(type(message), to_cdr(message)) == message
    from rcl_interfaces.srv import ListParameters  # type: ignore[import-not-found]

    assert ListParameters.Request.DEPTH_RECURSIVE == 0


def test_standard_services_are_there_in_a_confined_host(tmp_path: Path) -> None:
    (tmp_path / "server.py").write_text(
        "from rclpy.node import Node\n"
        "from std_srvs.srv import Trigger\n"
        "class Server(Node):\n"
        "    def __init__(self):\n"
        "        super().__init__('server')\n"
        "        self.create_service(Trigger, '~/start', lambda request, response: response)\n"
    )
    node = {"module": "server", "class": "Server", "name": "server", "component": None}
    with HostProcess() as host:
        ready = host.configure({"path": [str(tmp_path)], "messages": [], "nodes": [node]})
    assert [topic["topic"] for topic in ready["topics"]] == ["rq/server/startRequest", "rr/server/startReply"]


def test_a_call_within_a_callback_is_an_error_instead_of_a_wait_without_end(world: World, tmp_path: Path) -> None:
    source = tmp_path / "waiting.py"
    source.write_text(
        "import rclpy\n"
        "from std_srvs.srv import Trigger\n"
        "with rclpy.init():\n"
        "    node = rclpy.create_node('waiting')\n"
        "    client = node.create_client(Trigger, 'trigger')\n"
        "    print(client.call(Trigger.Request(), timeout_sec=0.05), flush=True)\n"
        "    node.create_timer(0.01, lambda: client.call(Trigger.Request()))\n"
        "    rclpy.spin(node)\n"
    )
    node = world.run(source)
    node.hears("None")
    assert node.ends() == 1
    assert node.said[-1].startswith("RuntimeError: within a callback call() would wait without end")
