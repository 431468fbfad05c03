"""Single node files: samples, callbacks, time, and termination."""

from __future__ import annotations

import signal
import threading
from itertools import cycle
from pathlib import Path
from time import sleep, time_ns

import pytest
from conftest import FIXTURES
from eventchain_ros2 import live
from eventchain_ros2.clock import Duration
from eventchain_ros2.dds_entities import Participant
from eventchain_ros2.endpoints import Publisher, Subscription
from eventchain_ros2.messages import Messages
from eventchain_ros2.qos import LivelinessPolicy, QoSProfile, ReliabilityPolicy, qos_profile_best_available
from node_processes import World, clock, number, numbers
from wire import DEFINITIONS, MILLISECOND, STRING, wait_until


def test_a_generated_node_file_runs_unchanged(world: World) -> None:
    node = world.run(FIXTURES / "chain" / "doubler_node.py")
    world.repeat(world.writer("/number"), number(3.0))
    reader = world.reader("/doubled")
    assert numbers(reader, 2)[:2] == [6.0, 6.0]
    node.process.send_signal(signal.SIGTERM)
    assert node.ends() == 1, "as with rclpy, for a node that catches nothing"
    # It was waiting, or in its callback: then spin() returns, and the node shuts down what the signal has shut down.
    assert any("ExternalShutdownException" in line or "already shut down" in line for line in node.said), node.said


@pytest.mark.parametrize(("shutdown", "code"), [("shutdown", 1), ("try_shutdown", 0)])
def test_a_signal_inside_a_callback_lets_it_end_and_spin_return(
    world: World, tmp_path: Path, shutdown: str, code: int
) -> None:
    source = tmp_path / "waiting.py"
    source.write_text(
        "import time, rclpy\n"
        "rclpy.init()\n"
        "node = rclpy.create_node('waiting')\n"
        "def wait():\n"
        "    print('waits', flush=True)\n"
        "    while rclpy.ok():\n"
        "        time.sleep(0.001)\n"
        "node.create_timer(0.01, wait)\n"
        "rclpy.spin(node)\n"
        "print('returned', flush=True)\n"
        f"rclpy.{shutdown}()\n"
    )
    node = world.run(source)
    node.hears("waits")
    node.process.send_signal(signal.SIGTERM)
    node.hears("returned")
    assert node.ends() == code
    assert any("already shut down" in line for line in node.said) == bool(code)


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
    node = world.probe(terminates="true")
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
    (made,) = [int(line.split()[1]) for line in node.said if line.startswith("made")]
    fired = [int(line.split()[1]) for line in node.said if line.startswith("fired")]
    assert before < fired[0] <= time_ns()
    assert fired[1] - fired[0] >= 1_050 * MILLISECOND
    assert fired[3] >= made + 1_300 * MILLISECOND, "a burst of what was missed"  # due at 0.1, 0.2 to 1.1, 1.2, 1.3 s


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
        for time in cycle(range(100, 9_000, 20)):
            shown.data = clock(time * MILLISECOND)
            if is_over.wait(0.02):
                break

    thread = threading.Thread(target=start_anew)
    thread.start()
    fired = int(node.hears("fired").split()[1])
    is_over.set()
    thread.join()
    assert fired < 9_000 * MILLISECOND, "not only when 9.5 s are shown again"


def test_what_is_missing_is_refused_at_the_call(world: World) -> None:
    node = world.probe(call="add_waitable")
    assert node.ends() == 1
    assert node.said[-1] == "NotImplementedError: waitables are not part of Eventchain's runtime"


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
    node = world.run("--messages", DEFINITIONS, file)
    from eventchain_ros2.catalog import read
    from eventchain_ros2.messages import Messages, to_cdr

    messages = Messages(read([DEFINITIONS]))
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
        "        pass\n"
        "    print('ended', flush=True)\n"
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


def test_what_a_node_raises_ends_the_process(world: World, tmp_path: Path) -> None:
    file = tmp_path / "broken.py"
    file.write_text("import rclpy\nrclpy.init()\nraise ValueError('broken')\n")
    node = world.run(file)
    assert node.ends() == 1
    assert node.said[-1] == "ValueError: broken"


def test_spinning_makes_one_wait_set(
    participants: tuple[Participant, Participant], monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[live.WaitSet] = []

    class Counted(live.WaitSet):
        def __init__(self, participant: Participant) -> None:
            super().__init__(participant)
            made.append(self)

    nodes = live.Live(participants[0], [])  # which has one for events
    monkeypatch.setattr(live, "WaitSet", Counted)
    try:
        process = nodes.add_process("idle")
        for _ in range(3):
            assert not nodes.spin_once({process}, 0)
    finally:
        nodes.stop()
    assert len(made) == 1


def test_what_is_best_available_is_decided_by_what_was_discovered(
    participants: tuple[Participant, Participant], messages: Messages
) -> None:
    other, own = participants
    modest = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=0.1))
    other.writer("/camera", STRING, modest)
    demanding = QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC)
    other.reader("/lamp", STRING, demanding)
    writers, readers = own.announced_writers(), own.announced_readers()
    wait_until(lambda: writers.profiles("rt/camera") and readers.profiles("rt/lamp"), "discovery")
    nodes = live.Live(own, [])
    try:
        process = nodes.add_process("node")
        arguments = nodes, process, messages.get(STRING)
        subscription = Subscription(*arguments, "/camera", print, qos_profile_best_available)
        publisher = Publisher(*arguments, "/lamp", qos_profile_best_available)
        asked, offered = subscription.qos_profile, publisher.qos_profile
        assert (asked.reliability.name, asked.durability.name, asked.liveliness.name) == (
            "BEST_EFFORT",
            "VOLATILE",
            "AUTOMATIC",
        )
        assert asked.deadline == Duration(seconds=0.1)
        assert (offered.reliability.name, offered.durability.name, offered.liveliness.name) == (
            "RELIABLE",
            "TRANSIENT_LOCAL",
            "MANUAL_BY_TOPIC",
        )
        alone = Subscription(*arguments, "/nobody", print, qos_profile_best_available)
        assert alone.qos_profile.durability.name == "TRANSIENT_LOCAL"
        assert not offered.deadline.nanoseconds
    finally:
        nodes.stop()


def test_a_future_of_another_thread_ends_spinning(world: World, tmp_path: Path) -> None:
    source = tmp_path / "spinning.py"
    source.write_text(
        "import threading, rclpy\n"
        "from rclpy.duration import Duration\n"
        "with rclpy.init():\n"
        "    node = rclpy.create_node('spinning')\n"
        "    future = rclpy.Future()\n"
        "    rate = node.create_rate(10)\n"
        "    def work():\n"
        "        rate.sleep()\n"
        "        node.get_clock().sleep_for(Duration(seconds=0.1))\n"
        "        future.set_result('done')\n"
        "    threading.Thread(target=work).start()\n"
        "    rclpy.spin_until_future_complete(node, future)\n"
        "    print(future.result(), flush=True)\n"
        "    guard = node.create_guard_condition(lambda: print('triggered', flush=True))\n"
        "    guard.trigger()\n"
        "    while True:\n"
        "        rclpy.spin_once(node, timeout_sec=0.1)\n"
    )
    node = world.run(source)
    assert node.hears("done") == "done"
    node.hears("triggered")
