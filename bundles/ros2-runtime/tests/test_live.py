"""Node files that are run by themselves, as real processes on the wire."""

from __future__ import annotations

import os
import signal
import struct
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from queue import Empty, Queue
from time import monotonic, sleep, time_ns

import pytest
from conftest import BUNDLE, FIXTURES
from eventchain_ros2.clock import Duration
from eventchain_ros2.dds_entities import Participant, Reader, Writer, loopback_configuration
from eventchain_ros2.definitions import Catalog
from eventchain_ros2.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from wire import DOMAIN, PATIENCE, fresh_tag, wait_until

FLOAT = "std_msgs/msg/Float32"
EVERY = QoSProfile(history=HistoryPolicy.KEEP_ALL)
BEST_EFFORT = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.BEST_EFFORT)
MILLISECOND = 1_000_000


class Running:
    """A node file that runs, and the lines that it has written."""

    def __init__(self, world: World, *arguments: object) -> None:
        command = [sys.executable, "-m", "eventchain_ros2", *map(str, arguments)]
        self.process = subprocess.Popen(
            command, env=world.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8"
        )
        self.said: list[str] = []
        self._lines: Queue[str | None] = Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._lines.put(line.rstrip("\n"))
        self._lines.put(None)

    def hears(self, start: str) -> str:
        """The next line that starts so; everything before it is skipped."""
        end = monotonic() + PATIENCE
        while True:
            try:
                line = self._lines.get(timeout=max(end - monotonic(), 0))
            except Empty:
                raise AssertionError(f"still waiting for '{start}' after {self.said}") from None
            assert line is not None, f"ended without '{start}' after {self.said}"
            self.said.append(line)
            if line.startswith(start):
                return line

    def ends(self) -> int:
        """Its exit code, once all it says is read."""
        code = self.process.wait(PATIENCE)
        while (line := self._lines.get(timeout=PATIENCE)) is not None:
            self.said.append(line)
        return code


class Repeated:
    """Writes the same sample again and again, until it is another one."""

    def __init__(self, writer: Writer, data: bytes) -> None:
        self.data = data
        self._writer = writer
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        while not self._is_over.wait(0.01):
            self._writer.write(self.data)

    def stop(self) -> None:
        self._is_over.set()
        self._thread.join()


class World:
    """The other side: a participant in a domain that only the processes of one test are in."""

    def __init__(self, domain: int) -> None:
        configuration = loopback_configuration(fresh_tag())
        self.participant = Participant(domain, configuration, Catalog([FIXTURES / "msg"]))
        self.environment = {**os.environ, "PYTHONPATH": str(BUNDLE / "python"), "CYCLONEDDS_URI": configuration}
        self.environment["ROS_DOMAIN_ID"] = str(domain)
        self._running: list[Running] = []
        self._repeated: list[Repeated] = []

    def run(self, *arguments: object) -> Running:
        self._running.append(Running(self, *arguments))
        return self._running[-1]

    def probe(self, **parameters: object) -> Running:
        values = [word for name, value in parameters.items() for word in ("-p", f"{name}:={value}")]
        return self.run(FIXTURES / "live" / "probe.py", "--ros-args", *values)

    def writer(self, topic: str, type_name: str = FLOAT, profile: QoSProfile = EVERY) -> Writer:
        writer = self.participant.writer(topic, type_name, profile)
        wait_until(writer.matched, f"a subscription on {topic}")
        return writer

    def reader(self, topic: str, profile: QoSProfile = EVERY) -> Reader:
        reader = self.participant.reader(topic, FLOAT, profile)
        wait_until(reader.matched, f"a publisher on {topic}")
        return reader

    def repeat(self, writer: Writer, data: bytes) -> Repeated:
        """Write again and again: of what is written first, a node that has not yet matched gets nothing."""
        self._repeated.append(Repeated(writer, data))
        return self._repeated[-1]

    def talk(self) -> tuple[Writer, Reader]:
        """Connect with a probe, in both directions, until it has answered."""
        writer, reader = self.writer("/room/in"), self.reader("/room/out")
        end = monotonic() + PATIENCE
        for hello in range(1, 1_000_000):
            writer.write(number(-hello))
            answers: list[bytes] = []
            for _ in range(30):
                sleep(0.01)
                answers += [each.data for each in reader.take()]
                if number(-2 * hello) in answers:
                    return writer, reader
            assert monotonic() < end, "the probe does not answer"
        raise AssertionError

    def close(self) -> None:
        for repeated in self._repeated:
            repeated.stop()
        for running in self._running:
            if running.process.poll() is None:
                running.process.kill()
                running.process.wait()
        self.participant.close()


@pytest.fixture
def world() -> Iterator[World]:
    world = World(DOMAIN)
    yield world
    world.close()


def number(value: float) -> bytes:
    return b"\0\1\0\0" + struct.pack("<f", value)


def numbers(reader: Reader, count: int) -> list[float]:
    taken: list[float] = []
    wait_until(
        lambda: taken.extend(struct.unpack("<f", each.data[4:])[0] for each in reader.take()) or len(taken) >= count,
        f"{count} numbers",
    )
    return taken


def clock(nanoseconds: int) -> bytes:
    return b"\0\1\0\0" + struct.pack("<iI", *divmod(nanoseconds, 1_000_000_000))


def test_a_generated_node_file_runs_unchanged(world: World) -> None:
    node = world.run(FIXTURES / "chain" / "doubler_node.py")
    world.repeat(world.writer("/number"), number(3.0))
    reader = world.reader("/doubled")
    assert numbers(reader, 2)[:2] == [6.0, 6.0]
    node.process.send_signal(signal.SIGTERM)
    node.ends()
    assert any("ExternalShutdownException" in line for line in node.said)


def test_samples_arrive_in_order_and_none_is_lost(world: World) -> None:
    node = world.probe()
    node.hears("ready True")
    writer, reader = world.talk()
    for value in range(200):
        writer.write(number(value))
        if value % 10 == 9:
            assert numbers(reader, 10) == [2.0 * each for each in range(value - 9, value + 1)]
    assert node.process.poll() is None


def test_two_node_files_talk_to_each_other(world: World, tmp_path: Path) -> None:
    source = tmp_path / "source.py"
    source.write_text(
        "import rclpy\n"
        "from rclpy.node import Node\n"
        "from std_msgs.msg import Float32\n"
        "rclpy.init()\n"
        "node = Node('source')\n"
        "publisher = node.create_publisher(Float32, '/room/in', 10)\n"
        "node.create_timer(0.02, lambda: publisher.publish(Float32(data=21.0)))\n"
        "rclpy.spin(node)\n"
    )
    probe, _ = world.probe(), world.run(source)
    assert probe.hears("received") == "received 21.0"
    assert numbers(world.reader("/room/out"), 1)[0] == 42.0


def test_the_node_is_in_the_graph_with_its_endpoints(world: World) -> None:
    world.probe().hears("ready")
    writer, reader = world.writer("/room/in"), world.reader("/room/out")
    wait_until(lambda: any(node.writers and node.readers for node in world.participant.nodes()), "the node")
    (node,) = world.participant.nodes()
    assert (node.name, node.namespace) == ("probe", "/room")
    assert node.writers == (reader.peers()[0].guid,)
    assert node.readers == (writer.peers()[0].guid,)


def test_an_interrupt_shuts_the_context_down_first(world: World) -> None:
    node = world.probe(period=0.01)
    node.hears("fired")  # it spins
    node.process.send_signal(signal.SIGINT)
    assert node.hears("interrupted") == "interrupted False"
    assert node.ends() == 0


def test_a_termination_ends_the_spin_from_outside(world: World) -> None:
    node = world.probe(period=0.01)
    node.hears("fired")  # it spins
    node.process.send_signal(signal.SIGTERM)
    assert node.hears("terminated") == "terminated False"
    assert node.ends() == 0


def test_a_callback_can_shut_down(world: World) -> None:
    node = world.probe(period=0.01, fires=3)
    assert node.hears("over") == "over False"
    assert node.ends() == 0
    assert len([line for line in node.said if line.startswith("fired")]) == 3


def test_timers_follow_the_clock_on_the_wall_and_skip_the_periods_that_passed(world: World) -> None:
    before = time_ns()
    node = world.probe(period=0.1, busy_at_first=1.05, fires=4)
    node.hears("over")
    fired = [int(line.split()[1]) for line in node.said if line.startswith("fired")]
    assert before < fired[0] <= time_ns()
    assert fired[1] - fired[0] >= 1_050 * MILLISECOND
    assert fired[3] - fired[1] >= 100 * MILLISECOND, "a burst of what was missed"


def test_callbacks_never_overlap(world: World) -> None:
    node = world.probe(period=0.005, busy=0.002)
    node.hears("ready")
    writer, reader = world.talk()
    for _ in range(50):
        writer.write(number(1.0))
        numbers(reader, 1)
    node.hears("fired")
    node.process.send_signal(signal.SIGINT)
    node.hears("interrupted")
    assert "overlap" not in node.said


def test_simulated_time_is_zero_until_the_clock_shows_some(world: World) -> None:
    node = world.probe(period=0.5, use_sim_time="true")
    assert node.hears("ready") == "ready True 0"
    shown = world.repeat(world.writer("/clock", "rosgraph_msgs/msg/Clock"), clock(400 * MILLISECOND))
    for time in (1_050, 1_499, 1_750, 2_250):
        shown.data = clock(time * MILLISECOND)
        if time != 1_499:
            assert node.hears("fired") == f"fired {time * MILLISECOND} False"
            sleep(0.1)  # time stands still, and so does the timer
    assert len([line for line in node.said if line.startswith("fired")]) == 3


def test_a_clock_that_starts_anew_takes_the_timers_along(world: World) -> None:
    node = world.probe(period=0.5, use_sim_time="true")
    node.hears("ready")
    shown = world.repeat(world.writer("/clock", "rosgraph_msgs/msg/Clock"), clock(9_100 * MILLISECOND))
    assert node.hears("fired") == f"fired {9_100 * MILLISECOND} False"
    is_over = threading.Event()

    def start_anew() -> None:
        for time in range(100, 9_000, 20):
            shown.data = clock(time * MILLISECOND)
            if is_over.wait(0.02):
                break

    thread = threading.Thread(target=start_anew)
    thread.start()
    fired = int(node.hears("fired").split()[1])
    is_over.set()
    thread.join()
    assert fired < 9_000 * MILLISECOND, "not only when 9.5 s are shown again"


@pytest.mark.parametrize("name", ["deadline", "probe:deadline", "/probe:deadline"])
def test_parameters_have_the_types_of_yaml(world: World, name: str) -> None:
    node = world.probe(**{name: "fast"})
    assert node.ends() == 1
    assert any("InvalidParameterTypeException" in line for line in node.said)
    other = world.probe(**{"other:deadline": "fast"})
    other.hears("ready")


def test_parameters_come_from_files_too_and_the_last_value_counts(world: World, tmp_path: Path) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n    period: 0.05\n    fires: 9\n"
        "/room/probe:\n  ros__parameters: {fires: 2}\n"
        "other:\n  ros__parameters: {fires: 5, nested: {deep: [1, 2]}}\n"
    )
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file)
    node.hears("over")
    assert len([line for line in node.said if line.startswith("fired")]) == 2
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file, "-p", "fires:=1")
    node.hears("over")
    assert len([line for line in node.said if line.startswith("fired")]) == 1


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("- 1\n", "below the name of a node"),
        ("probe: {fires: 1}\n", "below the name of a node"),
        ("/room/*: {ros__parameters: {}}\n", "/room/* is not part of Eventchain's runtime"),
        ("probe: [\n", "is not YAML"),
    ],
)
def test_a_wrong_file_of_parameters_is_explained(world: World, tmp_path: Path, text: str, problem: str) -> None:
    file = tmp_path / "parameters.yaml"
    file.write_text(text)
    node = world.run(FIXTURES / "live" / "probe.py", "--ros-args", "--params-file", file)
    assert node.ends() == 2
    assert problem in node.said[0]


def test_the_domain_is_that_of_the_environment(world: World) -> None:
    node = world.probe()
    node.hears("ready")
    world.writer("/room/in")
    world.environment["ROS_DOMAIN_ID"] = "first"
    refused = world.probe()
    assert refused.ends() == 2
    assert "error: ROS_DOMAIN_ID is not a number: first" in refused.said


def test_another_domain_is_another_world() -> None:
    one, other = World(DOMAIN), World(DOMAIN + 1)
    try:
        other.environment["CYCLONEDDS_URI"] = one.environment["CYCLONEDDS_URI"]
        stranger, friend = other.probe(), one.probe()
        stranger.hears("ready")
        friend.hears("ready")
        assert one.writer("/room/in").matched() == 1
    finally:
        one.close()
        other.close()


def test_policies_that_do_not_match_are_warned_of_on_both_sides(world: World) -> None:
    node = world.probe(reliable="false")
    node.hears("ready")
    world.participant.reader("/room/out", FLOAT, EVERY)
    assert node.hears("[WARN]") == (
        "[WARN] New subscription discovered on topic '/room/out', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: RELIABILITY"
    )
    reliable = world.probe()
    reliable.hears("ready")
    world.participant.writer("/room/in", FLOAT, BEST_EFFORT)
    assert reliable.hears("[WARN] New publisher") == (
        "[WARN] New publisher discovered on topic '/room/in', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: RELIABILITY"
    )


def test_missed_deadlines_are_warned_of(world: World) -> None:
    node = world.probe(deadline=0.2)
    node.hears("ready")
    deadline = QoSProfile(depth=1, deadline=Duration(seconds=0.1))
    repeated = world.repeat(world.writer("/room/in", profile=deadline), number(1.0))
    numbers(world.reader("/room/out"), 3)
    repeated.stop()
    warnings = {
        "[WARN] Deadline missed on topic '/room/in': nothing was received in time",
        "[WARN] Deadline missed on topic '/room/out': nothing was published in time",
    }
    while warnings:
        warnings.discard(node.hears("[WARN]"))


def test_a_definition_that_differs_is_warned_of(world: World, tmp_path: Path) -> None:
    file = tmp_path / "std_msgs" / "msg" / "Float32.msg"
    file.parent.mkdir(parents=True)
    file.write_text("float32 data\nfloat32 unit\n")
    node = world.run("--messages", tmp_path, FIXTURES / "live" / "probe.py")
    node.hears("ready")
    world.writer("/room/in")
    warning = node.hears("[WARN] The definition of std_msgs::msg::dds_::Float32_ on topic '/room/in' differs")
    assert warning.count("RIHS01_") == 2


def test_the_same_definition_is_no_warning(world: World) -> None:
    node = world.probe()
    node.hears("ready")
    world.talk()
    node.process.send_signal(signal.SIGINT)
    assert node.ends() == 0
    assert [line for line in node.said if "WARN" in line] == []


@pytest.mark.parametrize("call", ["create_service", "create_client"])
def test_services_are_refused_at_the_call(world: World, call: str) -> None:
    node = world.probe(call=call)
    assert node.ends() == 1
    assert node.said[-1] == "NotImplementedError: services are not part of Eventchain's runtime"


def test_own_messages_are_found(world: World, tmp_path: Path) -> None:
    file = tmp_path / "listener.py"
    file.write_text(
        "import rclpy\n"
        "from rclpy.node import Node\n"
        "from carla_msgs.msg import CarlaEgoVehicleStatus\n"
        "rclpy.init()\n"
        "node = Node('listener')\n"
        "node.create_subscription(CarlaEgoVehicleStatus, 'status', lambda m: print(m.control.steer, flush=True), 10)\n"
        "rclpy.spin(node)\n"
    )
    node = world.run("--messages", FIXTURES / "msg", file)
    from eventchain_ros2.messages import Messages, to_cdr

    messages = Messages([FIXTURES / "msg"])
    status = messages.get("carla_msgs/msg/CarlaEgoVehicleStatus")()
    status.control.steer = 0.5
    world.repeat(world.writer("/status", "carla_msgs/msg/CarlaEgoVehicleStatus"), bytes(to_cdr(status)))
    node.hears("0.5")


def test_executors_in_threads_run_their_own_nodes(world: World, tmp_path: Path) -> None:
    file = tmp_path / "threads.py"
    file.write_text(
        "import threading\n"
        "import rclpy\n"
        "from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor\n"
        "from rclpy.node import Node\n"
        "from std_msgs.msg import Float32\n"
        "rclpy.init()\n"
        "one, other = Node('one'), Node('other')\n"
        "def heard(name):\n"
        "    print(name, threading.current_thread().name, flush=True)\n"
        "def spin(executor):\n"
        "    try:\n"
        "        executor.spin()\n"
        "    except ExternalShutdownException:\n"
        "        print('ended', flush=True)\n"
        "one.create_subscription(Float32, '/one', lambda _: heard('one'), 10)\n"
        "other.create_subscription(Float32, '/other', lambda _: heard('other'), 10)\n"
        "executor = SingleThreadedExecutor()\n"
        "executor.add_node(other)\n"
        "thread = threading.Thread(target=spin, args=(executor,), name='second')\n"
        "thread.start()\n"
        "try:\n"
        "    rclpy.spin(one)\n"
        "except ExternalShutdownException:\n"
        "    thread.join()\n"
    )
    node = world.run(file)
    for name, thread in (("one", "MainThread"), ("other", "second")) * 2:
        repeated = world.repeat(world.writer(f"/{name}"), number(1.0))
        assert node.hears(name) == f"{name} {thread}"
        repeated.stop()
    node.process.send_signal(signal.SIGTERM)
    node.hears("ended")
    assert node.ends() == 0


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ([], "there is no file to run"),
        (["no_such_node.py"], "there is no file no_such_node.py"),
        (["--fast", __file__], "unexpected argument --fast"),
        (["--messages"], "unexpected argument --messages"),
        ([__file__, "--ros-args", "-p", "period"], "-p wants NAME:=VALUE"),
        ([__file__, "--ros-args", "-p"], "-p wants NAME:=VALUE"),
        ([__file__, "--ros-args", "-p", "x:=[1"], "the value of parameter x is not YAML: [1"),
        ([__file__, "--ros-args", "-p", "x:={a: 1}"], "parameter x cannot have the value {'a': 1}"),
        ([__file__, "--ros-args", "--params-file", "none.yaml"], "none.yaml cannot be read"),
        ([__file__, "--ros-args", "-r", "a:=b"], "-r is not part of Eventchain's runtime"),
    ],
)
def test_a_wrong_command_line_is_explained(world: World, arguments: list[str], problem: str) -> None:
    node = world.run(*arguments)
    assert node.ends() == 2
    assert node.said[0].startswith(f"error: {problem}")


def test_without_the_library_it_says_what_to_do(world: World) -> None:
    world.environment["EVENTCHAIN_LIBDDSC"] = "/no/such/libddsc.so"
    node = world.probe()
    assert node.ends() == 3
    assert node.said[0].startswith("error: /no/such/libddsc.so cannot be loaded")
    assert node.said[1].startswith("hint: ")


def test_what_a_node_raises_ends_the_process(world: World, tmp_path: Path) -> None:
    file = tmp_path / "broken.py"
    file.write_text("import rclpy\nrclpy.init()\nraise ValueError('broken')\n")
    node = world.run(file)
    assert node.ends() == 1
    assert node.said[-1] == "ValueError: broken"
