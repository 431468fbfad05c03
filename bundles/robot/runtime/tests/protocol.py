"""The other end of the lock-step protocol, for tests and benchmarks."""

from __future__ import annotations

import json
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing_extensions import Self

SOURCES = Path(__file__).parents[1] / "python"
CONFINEMENT = Path(__file__).parents[2] / "sandbox" / "src" / "main" / "resources" / "dev" / "eventchain" / "sandbox"
BOOTSTRAP = "import sys, confined; confined.main(sys.argv[1])"
CONFIGURE, READY, STEP, STEPPED, FINISH, FINISHED, FAILED, RESET = range(1, 9)
CONNECT, CONNECTED, PUBLISH, RUN, IDLE, START, STOP = range(9, 16)
MILLISECOND = 1_000_000


class Failed(Exception):
    """The host answered with a FAILED frame."""

    def __init__(self, details: dict[str, Any]) -> None:
        super().__init__(f"{details['id']}: {details['message']}")
        self.details = details


class HostProcess:
    """A host confined as in the product, but without bubblewrap, driven over real pipes."""

    module = "eventchain_ros2.lockstep"
    preparation: dict[str, Any] | None = None

    def __init__(self, stderr: int | None = subprocess.PIPE) -> None:
        self._temporary = tempfile.TemporaryDirectory()
        self.work = Path(self._temporary.name).resolve()
        settings = {
            "work": str(self.work),
            "readable": ["/"],
            "path": [str(SOURCES), str(CONFINEMENT)],
            "module": self.module,
            "arguments": [],
            "limits": {"cpuSeconds": 600, "memory": 1 << 30, "fileSize": 1 << 20, "openFiles": 256},
            "enclosed": False,
            "kernel": True,
            "hooks": True,
            "components": True,
            "turn": 0,
            "parent": os.getpid(),
        }
        if self.preparation is not None:
            settings["preparation"] = self.preparation
        environment = {"PATH": os.environ["PATH"], "PYTHONPATH": str(CONFINEMENT), "OPENBLAS_NUM_THREADS": "1"}
        command = [sys.executable, "-c", BOOTSTRAP, json.dumps(settings)]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=stderr, env=environment)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.process.kill()
        with self.process:
            pass
        self._temporary.cleanup()

    def send(self, kind: int, payload: bytes = b"") -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(struct.pack("<IB", len(payload) + 1, kind) + payload)
        self.process.stdin.flush()

    def receive(self, expected: int) -> bytes:
        assert self.process.stdout is not None
        length, kind = struct.unpack("<IB", self.process.stdout.read(5))
        payload = self.process.stdout.read(length - 1)
        if kind == FAILED:
            raise Failed(json.loads(payload))
        assert kind == expected, f"expected a frame of kind {expected}, got {kind}"
        return payload

    def configure(self, configuration: dict[str, Any], kind: int = CONFIGURE) -> Any:
        self.send(kind, json.dumps(configuration).encode())
        return json.loads(self.receive(READY))

    def step(self, until: int, *samples: tuple[int, bytes]) -> list[tuple[int, int, bytes]]:
        """Publish `(topic index, CDR bytes)` and let time pass; return `(time, topic index, CDR bytes)`."""
        self.send(STEP, step_payload(until, *samples))
        return _samples(self.receive(STEPPED))

    def finish(self) -> Any:
        self.send(FINISH)
        return json.loads(self.receive(FINISHED))

    def close(self) -> tuple[int, str]:
        """End the input; return exit code and standard error."""
        _, errors = self.process.communicate()
        return self.process.returncode, (errors or b"").decode()


def step_payload(until: int, *samples: tuple[int, bytes]) -> bytes:
    parts = [struct.pack("<qH", until, len(samples))]
    for index, data in samples:
        parts += (struct.pack("<HI", index, len(data)), data)
    return b"".join(parts)


def _samples(payload: bytes) -> list[tuple[int, int, bytes]]:
    (count,) = struct.unpack_from("<H", payload)
    position, samples = 2, []
    for _ in range(count):
        time, index, length = struct.unpack_from("<qHI", payload, position)
        position += 14
        samples.append((time, index, payload[position : position + length]))
        position += length
    assert position == len(payload)
    return samples


def float32(value: float) -> bytes:
    """Return the CDR bytes of a std_msgs/msg/Float32."""
    return b"\x00\x01\x00\x00" + struct.pack("<f", value)


def doubler(folder: Path, package: str = "chain", **component: Any) -> dict[str, Any]:
    """Return the node of the fixture `chain` or `dds` in this folder, with its component."""
    described = {
        "module": f"{package}.components.Doubler",
        "class": "Doubler",
        "file": f"{folder}/{package}/components/Doubler.py",
        "inputs": ["number"],
        "outputs": [{"name": "doubled"}],
    }
    node = {"module": f"{package}.doubler_node", "class": "Doubler_node", "name": "Doubler"}
    return {**node, "component": {**described, **component}}
