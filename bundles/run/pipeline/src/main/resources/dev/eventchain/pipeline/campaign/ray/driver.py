"""Run the parts of a campaign as tasks of a Ray cluster.

    python driver.py

Lines of JSON on standard input and output. The program first says what is to be done:
``{"address", "class_path", "java_options", "arguments", "settings", "output", "files", "folders"}``, where an empty
address stands for a cluster of this machine alone. The answer ``{"slots", "processors"}`` says how many parts run at
once, on how many processors each. Then follows ``{"count", "parts"}``: how many parts there are, and the numbers of
those to be simulated. Each is answered by ``{"part", "node", "cases"}``, and all of them by ``{"ended": true}``.
``{"error", "hint"}`` is the last line if something fails, and ``{"alive": true}`` says in between that nothing has.

A part that is lost with its node, or with the process that simulates it, runs again, ``RETRIES`` times at most; one
that fails is an error. Nothing waits without a limit: neither for an answer of Ray (``STEP_SECONDS``) nor for parts
that nobody works on (``STALL_SECONDS``). A part that takes long on a busy node is waited for. The end of standard input
ends everything.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import secrets
import shutil
import socket
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TextIO

import node
import packs

RETRIES = 5
# A task that wants all of a large node waits until everything else there has ended.
MOST_PROCESSORS = 8
PATIENCE_SECONDS = 0.5
GRACE_SECONDS = 20
ALIVE_SECONDS = 10
STALL_SECONDS = 300
STEP_SECONDS = 600
MIB = 1 << 20
KEPT = "Look at 'ray status'. What has come back is kept: the same command goes on."
WITHOUT_CLUSTER = (
    "Start one by 'ray start --head', with the same versions of Ray and Python as here; this machine has to be a node."
)


class DriverError(Exception):
    """Failure for users, with a hint."""

    def __init__(self, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.hint = hint


class Channel:
    """Messages from and to the program."""

    def __init__(self, source: TextIO, target: TextIO) -> None:
        self._source = source
        self._target = target
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._sending = threading.Lock()
        self.closed = threading.Event()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        for line in self._source:
            self._lines.put(line)
        self.closed.set()
        self._lines.put("")

    def receive(self) -> dict[str, Any]:
        """Return the next message."""
        line = self._lines.get()
        if not line:
            raise EOFError
        message: dict[str, Any] = json.loads(line)
        return message

    def send(self, **message: object) -> None:
        """Send a message."""
        with self._sending:
            self._target.write(json.dumps(message) + "\n")
            self._target.flush()

    @contextlib.contextmanager
    def limited(self, step: str, seconds: float = STEP_SECONDS) -> Iterator[None]:
        """End this process, and say why, if a step takes longer: calls of Ray cannot be interrupted."""

        def end() -> None:
            self.send(error=f"Ray has not answered for {seconds:g} s, while {step}", hint=KEPT)
            os._exit(1)

        timer = threading.Timer(seconds, end)
        timer.daemon = True
        timer.start()
        try:
            yield
        finally:
            timer.cancel()


def main() -> int:
    """Serve the program that has started this one; return the exit code."""
    # Ctrl-C is for the program: the end of its lines ends this one, and with it all tasks.
    with contextlib.suppress(PermissionError):
        os.setsid()
    # Ray prints, too.
    target = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    channel = Channel(sys.stdin, target)
    threading.Thread(target=give_up, args=[channel.closed], daemon=True).start()
    try:
        serve(channel)
    except DriverError as problem:
        channel.send(error=str(problem), hint=problem.hint)
        return 1
    except EOFError:
        return 1
    return 0


def give_up(closed: threading.Event) -> None:
    """End this process if it does not end in time after the program; Ray may wait for long."""
    closed.wait()
    time.sleep(GRACE_SECONDS)
    os._exit(1)


def serve(channel: Channel) -> None:
    """Do what the program asks for."""
    request = channel.receive()
    program = packs.pack(packs.program([Path(entry) for entry in request["class_path"]]))
    folders = [
        packs.Folder(Path(each["folder"]), frozenset(Path(name) for name in each["without"]), each["hidden"])
        for each in request["folders"]
    ]
    files = packs.pack(packs.project([Path(name) for name in request["files"]], folders))
    with connected(request["address"], len(program.content) + len(files.content), channel) as ray:
        with channel.limited("its nodes were asked for"):
            slots, processors = capacity(ray.nodes())
        channel.send(slots=slots, processors=processors)
        parts = channel.receive()
        work = node.Work(
            program.name,
            files.name,
            [packs.entry_name(number, Path(entry)) for number, entry in enumerate(request["class_path"])],
            request["java_options"],
            request["arguments"],
            packs.place(Path(request["output"])),
            request["settings"],
            processors,
        )
        with channel.limited("program and project were handed to it"):
            tasks = Tasks(ray, work, [program, files], parts["count"])
        run(tasks, parts["parts"], slots, channel, Watch(tasks, channel))
        channel.send(ended=True)


@contextlib.contextmanager
def connected(address: str, size: int, channel: Channel) -> Iterator[Any]:
    """Return Ray, connected to a cluster, or to a new one of this machine, which is ended again."""
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    # Ray's own setting is without end: a part that needs more memory than there is would be tried for ever.
    os.environ.setdefault("RAY_task_oom_retries", str(RETRIES))
    quiet = {"log_to_driver": False, "logging_level": "ERROR"}
    if address:
        require_reachable(address)
        failure = f"The Ray cluster at '{address}' cannot be used"
        yield from attempt(lambda ray: ray.init(address=address, **quiet), failure, channel)
        return
    # Ray listens on all interfaces, also where all is on one machine. Without the token, nobody can use what listens.
    os.environ.update(RAY_AUTH_MODE="token", RAY_AUTH_TOKEN=secrets.token_hex(32))
    # Ray lets tasks give way to all else (15), so that beside other work they hardly go on.
    os.environ.setdefault("RAY_worker_niceness", "0")
    # The paths of Ray's sockets, in this folder, may have 107 characters.
    folder = tempfile.mkdtemp(prefix="eventchain-ray-", dir="/tmp")
    options = {"include_dashboard": False, "object_store_memory": 2 * size + 128 * MIB, "_temp_dir": folder, **quiet}
    try:
        yield from attempt(lambda ray: ray.init(address="local", **options), "Ray cannot be started", channel)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def require_reachable(address: str) -> None:
    """Refuse an address for which Ray would wait for minutes."""
    if "://" in address:
        raise DriverError("Ray Client is not supported", "Name HOST:PORT, or auto, on a node of the cluster.")
    host, colon, port = address.rpartition(":")
    if not colon:
        return  # such as auto
    try:
        socket.create_connection((host.strip("[]"), int(port)), timeout=10).close()
    except (OSError, ValueError) as problem:
        reason = problem.strerror if isinstance(problem, OSError) else problem
        raise DriverError(f"There is no Ray cluster at '{address}': {reason}", WITHOUT_CLUSTER) from problem


def attempt(start: Callable[[Any], object], failure: str, channel: Channel) -> Iterator[Any]:
    """Return Ray after a start of it."""
    import ray  # reads the settings of the caller

    try:
        with channel.limited("it was connected to"):
            start(ray)
    except (OSError, RuntimeError, ValueError, ray.exceptions.RayError) as problem:
        raise DriverError(f"{failure}: {one_line(str(problem))}", WITHOUT_CLUSTER) from problem
    try:
        yield ray
    finally:
        ray.shutdown()


def capacity(nodes: list[dict[str, Any]]) -> tuple[int, int]:
    """Return how many parts can run at once, and on how many processors each."""
    counts = [int(each["Resources"].get("CPU", 0)) for each in nodes if each["Alive"]]
    counts = [count for count in counts if count > 0]
    if not counts:
        raise DriverError("No node of the cluster has a processor for tasks", "Start nodes with --num-cpus.")
    processors = min(MOST_PROCESSORS, min(counts))
    return sum(count // processors for count in counts), processors


class Tasks:
    """Starts tasks for parts, and returns what became of them."""

    def __init__(self, ray: Any, work: node.Work, content: list[packs.Pack], count: int) -> None:
        self._ray = ray
        self._work = work
        self._count = count
        ray.cloudpickle.register_pickle_by_value(node)
        # Each pack is one object, of which a node gets a copy when a part first asks for it.
        packed = {each.name: ray.put(each.content) for each in content}

        def task(work: node.Work, packed: dict[str, Any], number: int, count: int) -> node.Part:
            import ray  # the node's

            return node.run_part(work, lambda name: ray.get(packed[name], timeout=STEP_SECONDS), number, count)

        self._packed = packed
        self._task = ray.remote(task).options(
            num_cpus=work.processors, max_retries=RETRIES, scheduling_strategy="SPREAD", name="eventchain campaign"
        )

    def start(self, number: int) -> Any:
        """Start a part."""
        return self._task.remote(self._work, self._packed, number, self._count)

    def wait(self, started: list[Any]) -> list[Any]:
        """Return one that has ended, if there is one before long."""
        done: list[Any] = self._ray.wait(started, num_returns=1, timeout=PATIENCE_SECONDS)[0]
        return done

    def result(self, number: int, done: Any) -> node.Part | None:
        """Return what became of a part; nothing if it is on its way, or was lost and runs again."""
        try:
            part: node.Part = self._ray.get(done, timeout=PATIENCE_SECONDS)
        except self._ray.exceptions.GetTimeoutError:
            return None
        except self._ray.exceptions.RayTaskError as problem:
            return node.Part("", failure=str(problem.cause if problem.cause is not None else problem))
        except self._ray.exceptions.RayError as problem:
            raise DriverError(
                f"Part {number} was lost {RETRIES + 1} times, each time with its node or its process:"
                f" {one_line(str(problem))}",
                "A node may have too little memory for it.",
            ) from problem
        return part

    def idle(self) -> str:
        """Return why nothing can be going on; empty if a node works, for us or for others."""
        counts = [float(each["Resources"].get("CPU", 0)) for each in self._ray.nodes() if each["Alive"]]
        if all(count < self._work.processors for count in counts):
            return f"no node with {self._work.processors} processors is left"
        if self._ray.available_resources().get("CPU", 0) < sum(counts):
            return ""
        return f"no part runs, though all {sum(counts):g} processors are free"


class Watch:
    """Notices that nobody works on the parts, and says to the program that it looks."""

    def __init__(self, tasks: Tasks, channel: Channel, clock: Callable[[], float] = time.monotonic) -> None:
        self._tasks = tasks
        self._channel = channel
        self._clock = clock
        self._looked = self._worked = clock()

    def look(self) -> None:
        """Look now and then; raise an error once nobody has worked for too long."""
        now = self._clock()
        if now - self._looked < ALIVE_SECONDS:
            return
        with self._channel.limited("its nodes were asked for"):
            idle = self._tasks.idle()
        self._looked = now
        self._channel.send(alive=True)
        if not idle:
            self._worked = now
        elif now - self._worked >= STALL_SECONDS:
            raise DriverError(f"Nobody has worked on the campaign for {STALL_SECONDS} s: {idle}", KEPT)

    def worked(self) -> None:
        """Note that a part has come back."""
        self._worked = self._clock()


def run(tasks: Tasks, numbers: list[int], slots: int, channel: Channel, watch: Watch) -> None:
    """Run parts until all are done, one has failed, or the program has ended."""
    waiting = list(reversed(numbers))
    started: dict[Any, int] = {}
    while waiting or started:
        if channel.closed.is_set():
            raise EOFError
        # Some more than run at once, so that no node waits for its next one.
        while waiting and len(started) < 2 * slots + 4:
            number = waiting.pop()
            started[tasks.start(number)] = number
        watch.look()
        for done in tasks.wait(list(started)):
            number = started[done]
            part = tasks.result(number, done)
            if part is None:
                continue
            del started[done]
            watch.worked()
            if part.failure:
                where = f" on the node {part.node}" if part.node else ""
                raise DriverError(f"Part {number} failed{where}: {telling(part.failure)}", part.hint)
            channel.send(part=number, node=part.node, cases=part.cases)


def telling(output: str) -> str:
    """Return the line of a program's output that says why it failed: the first finding, or else the last line."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    findings = [line for line in lines if ": error: " in line or line.startswith("error: ")]
    return (findings or lines[-1:] or ["no output"])[0]


def one_line(text: str) -> str:
    """Return a text without line breaks, shortened."""
    line = " ".join(text.split())
    return line if len(line) <= 400 else line[:399] + "…"


if __name__ == "__main__":
    sys.exit(main())
