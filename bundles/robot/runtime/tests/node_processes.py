"""Single node files as real processes on the wire, and their peers."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import threading
from pathlib import Path
from queue import Empty, Queue
from time import monotonic, sleep

from eventchain_ros2.catalog import Catalog, read
from eventchain_ros2.dds_entities import Participant, Reader, Writer
from eventchain_ros2.qos import QoSProfile
from wire import DEFINITIONS, EVERY, PATIENCE, fresh_tag, loopback_configuration, wait_until

FIXTURES = Path(__file__).with_name("fixtures")
SOURCES = Path(__file__).parents[1] / "python"
FLOAT = "std_msgs/msg/Float32"


class Running:
    """A running node file or other program, and its output lines."""

    def __init__(self, environment: dict[str, str], *arguments: object) -> None:
        command = [sys.executable, *map(str, arguments)]
        self.process = subprocess.Popen(
            command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8"
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
        """Return the next line with this start, skipping earlier lines."""
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
        """Return its exit code after reading its complete output."""
        code = self.process.wait(PATIENCE)
        while (line := self._lines.get(timeout=PATIENCE)) is not None:
            self.said.append(line)
        return code


class Repeated:
    """Writes the same sample repeatedly, until it is replaced."""

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
    """The other side: a participant in a domain for the processes of one test only."""

    def __init__(self, domain: int, tag: str | None = None) -> None:
        configuration = loopback_configuration(tag or fresh_tag())
        self.participant = Participant(domain, configuration, Catalog(read([DEFINITIONS])))
        self.environment = {**os.environ, "PYTHONPATH": str(SOURCES), "CYCLONEDDS_URI": configuration}
        self.environment["ROS_DOMAIN_ID"] = str(domain)
        self._running: list[Running] = []
        self._repeated: list[Repeated] = []

    def run(self, *arguments: object) -> Running:
        self._running.append(Running(self.environment, "-m", "eventchain_ros2", *arguments))
        return self._running[-1]

    def foreign(self, *arguments: object) -> Running:
        """Run a Python program that sees nothing of this runtime."""
        elsewhere = {name: value for name, value in self.environment.items() if name != "PYTHONPATH"}
        self._running.append(Running(elsewhere, *arguments))
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
        """Write repeatedly: a node that has not yet matched misses the first samples."""
        self._repeated.append(Repeated(writer, data))
        return self._repeated[-1]

    def talk(self) -> tuple[Writer, Reader]:
        """Connect with a probe in both directions, until it has answered."""
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
