"""Client of component processes, for the process that calls components and records their results.

Untrusted code shares only a socket with this process. Data that are not a value end the component. Arrival times and
processor time are measured here and by the kernel.
"""

from __future__ import annotations

import json
import os
import re
import socket
import struct
import time
from array import array
from pathlib import Path
from typing import Any, NamedTuple

from component_results import VALUE_HINT
from component_values import LONGEST, NO_OBJECTS, Codec, MalformedError, Objects

_HEADER = struct.Struct("<I4s")
_TOKEN_BYTES = 4
_FIRST_READ = 1 << 16
_FRAME = re.compile(r'^ {2}File "(.*)", line (\d+) in', re.MULTILINE)
_PATIENCE = 2.0  # s for the stack of a process that hangs
_SIGXCPU = 24
_NANOSECONDS = 1_000_000_000
_TOO_LATE_HINT = "Compute with loops that end, without waiting."
_ENDED_HINT = "Do not end the process."
_CRASHED_HINT = "It crashed in native code, or something ended it."
_LONGEST_TEXT = 500
_MOST_COMPILED = 100


class ComponentError(BaseException):
    """A component gave no result. Not an `Exception`, so that nodes which catch those do not continue without it.

    Args:
        identifier: `component.raised`, `.syntax`, `.timeout`, `.ended` or `.result.type`.
        message: description in one line.
        file: the place, with 1-based line and column; 0: unknown.
        hint: what to do about it.

    """

    def __init__(
        self,
        identifier: str,
        message: str,
        file: str = "",
        line: int = 0,
        column: int = 0,
        hint: str = "",
    ) -> None:
        super().__init__(message)
        self.identifier = identifier
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self.hint = hint


class Limits(NamedTuple):
    """Limits of a component for one answer, in s: processor time, and wall time for components that sleep."""

    processor: float
    wall: float


class Result(NamedTuple):
    """Result of `execute`, the reported place of its `return`, and its processor time in ns."""

    values: Any
    line: int
    column: int
    processor: int


class ForkServer:
    """Client of the fork server, this process's parent, which starts and ends processes: see :mod:`fork_server`."""

    def __init__(self, control: socket.socket) -> None:
        self._control = control

    @classmethod
    def inherited(cls) -> ForkServer:
        """Return the server that started this process."""
        if _INHERITED is None:
            raise RuntimeError("this process was not started by confined.py, which starts those of components")
        return cls(_INHERITED)

    def start(self, description: dict[str, Any]) -> tuple[int, int, int]:
        """Start the process of a component; return its id, and file descriptors of its channel and of its stack."""
        self._control.send(json.dumps(["start", description]).encode())
        descriptors = array("i")
        message, ancillary, _, _ = self._control.recvmsg(64, socket.CMSG_SPACE(2 * descriptors.itemsize))
        for _, _, data in ancillary:
            descriptors.frombytes(data[: len(data) - len(data) % descriptors.itemsize])
        channel, stack = descriptors
        return int(message), channel, stack

    def show_stack(self, process: int) -> None:
        """Make a process write its stack."""
        self._ask("stack", process)

    def end(self, process: int) -> int:
        """End a process if it is still running; return its exit code, or the negative number of a signal."""
        return self._ask("end", process)

    def _ask(self, what: str, process: int) -> int:
        self._control.send(json.dumps([what, process]).encode())
        return int(self._control.recv(64))


_INHERITED: socket.socket | None = None


def inherit(control: socket.socket) -> None:
    """Take the socket of the :class:`ForkServer`, made before audit hooks refuse sockets."""
    global _INHERITED
    _INHERITED = control


# Compiled code by file content, oldest first, with the place of execute().
_COMPILED: dict[tuple[str, str, bytes], list[Any]] = {}


class ComponentProcess:
    """One component. The calls raise :class:`ComponentError`, after which the process has been ended.

    Args:
        server: starts the process.
        description: see `component_process.ComponentProcess`.
        limits: for each answer.
        objects: objects that may be sent besides plain values.

    """

    def __init__(
        self, server: ForkServer, description: dict[str, Any], limits: Limits, objects: Objects = NO_OBJECTS
    ) -> None:
        self._server = server
        self._file: str = description["file"]
        self._class_name: str = description["class"]
        self._sources: list[str] = description["sources"]
        self._limits = limits
        self._codec = Codec(objects)
        self._ended = False
        self._process, self._channel, self._stack = server.start(description)
        self._clock = (~self._process << 3) | 2  # the processor time of another process, clock_getcpuclockid(3)
        self._asked_at = 0
        self._deadline = 0.0
        self._token = b""
        self._buffer = memoryview(bytearray(_FIRST_READ))

    def load(self) -> None:
        """Import the file."""
        self._expect_done(self._ask(["load", *self._compiled()]))

    def _compiled(self) -> list[Any]:
        """Return what the process that compiled this content first, before it ran any of it, made of the file."""
        try:
            content = Path(self._file).read_bytes()
        except OSError as problem:
            raise self._raised(type(problem).__name__, str(problem), self._file, 0, 0) from None
        key = self._file, self._class_name, content
        if key not in _COMPILED:
            answer = self._ask(["compile", content])
            if len(answer) != 4 or answer[0] != "code" or type(answer[1]) is not bytes:
                raise self._strange()
            while len(_COMPILED) >= _MOST_COMPILED:
                del _COMPILED[next(iter(_COMPILED))]
            _COMPILED[key] = [answer[1], _number(answer[2]), _number(answer[3])]
        return _COMPILED[key]

    def make(self) -> None:
        """Create the object, or another one in its place."""
        self._expect_done(self._ask(["make"]))

    def call(self, arguments: tuple[Any, ...], inputs: dict[str, Any]) -> Result:
        """Execute it."""
        answer = self._ask(["call", arguments, inputs])
        processor = time.clock_gettime_ns(self._clock) - self._asked_at
        if answer[0] == "result" and len(answer) == 4:
            return Result(answer[1], _number(answer[2]), _number(answer[3]), processor)
        if answer[0] == "unfit" and len(answer) == 5:
            what, hint = (", not dict", "") if answer[2] is None else (f" for '{_line(answer[2])}'", VALUE_HINT)
            text = f"execute() returned {_line(answer[1])}{what}"
            place = self._file, _number(answer[3]), _number(answer[4])
            raise self._error("component.result.type", text, *place, hint=hint)
        raise self._strange()

    def series(self, calls: list[dict[str, Any]]) -> list[Any]:
        """Execute it several times with these inputs; return the results, which are not checked."""
        answer = self._ask(["series", calls])
        if answer[0] == "series" and len(answer) == 2 and type(answer[1]) is list and len(answer[1]) == len(calls):
            return answer[1]
        raise self._strange()

    def close(self) -> int:
        """End the process; return its exit code, or the negative number of a signal."""
        if self._ended:
            return 0
        self._ended = True
        os.close(self._channel)
        status = self._server.end(self._process)
        os.close(self._stack)
        return status

    def _expect_done(self, answer: list[Any]) -> None:
        if answer != ["done"]:
            raise self._strange()

    def _ask(self, question: list[Any]) -> list[Any]:
        if self._ended:
            raise ComponentError("component.ended", "the process of the component has ended", self._file)
        self._asked_at = time.clock_gettime_ns(self._clock)
        self._deadline = time.monotonic() + self._limits.wall
        self._token = os.urandom(_TOKEN_BYTES)  # prevents answers sent before the question
        self._send(self._codec.write(question))
        try:
            answer = self._codec.read(self._receive())
        except MalformedError:
            raise self._strange() from None
        if type(answer) is not list or not answer:
            raise self._strange()
        if answer[0] == "raised" and len(answer) == 6:
            raise self._raised(*answer[1:])
        return answer

    def _send(self, buffers: list[Any]) -> None:
        length = sum(map(len, buffers))
        header = _HEADER.pack(length, self._token)
        written = self._write([header, *buffers])
        if written < length + _HEADER.size:
            rest = memoryview(b"".join((header, *buffers)))
            while written < len(rest):
                written += self._write([rest[written:]])

    def _write(self, buffers: list[Any]) -> int:
        """Write as much as fits; the socket times out periodically (SO_SNDTIMEO)."""
        while True:
            try:
                return os.writev(self._channel, buffers)
            except BlockingIOError:
                self._check_deadlines()
            except OSError:
                raise self._gone() from None

    def _receive(self) -> memoryview:
        view = self._buffer
        have = self._read(view)
        while have < _HEADER.size:
            have += self._read(view[have:])
        length, token = _HEADER.unpack_from(view)
        whole = length + _HEADER.size
        if token != self._token or length > LONGEST or have > whole:
            raise self._strange()
        if whole > len(view):
            view = memoryview(bytearray(whole))
            view[:have] = self._buffer[:have]
        while have < whole:
            have += self._read(view[have:whole])
        return view[_HEADER.size : whole]

    def _read(self, view: memoryview) -> int:
        """Read the available bytes; the socket times out periodically (SO_RCVTIMEO)."""
        while True:
            try:
                count = os.readv(self._channel, [view])
            except BlockingIOError:
                self._check_deadlines()
                continue
            except OSError:
                raise self._gone() from None
            if count == 0:
                raise self._gone()
            return count

    def _check_deadlines(self) -> None:
        try:
            used = time.clock_gettime_ns(self._clock) - self._asked_at
        except OSError:
            raise self._gone() from None
        if used > self._limits.processor * _NANOSECONDS:
            raise self._late(f"it used more than {self._limits.processor:g} s of processor time")
        if time.monotonic() > self._deadline:
            raise self._late(f"it did not answer within {self._limits.wall:g} s")

    def _late(self, message: str) -> ComponentError:
        line = self._line_of_stack()
        return self._error("component.timeout", message, self._file, line, hint=_TOO_LATE_HINT)

    def _line_of_stack(self) -> int:
        """Return the innermost line of the component in the process's stack, 0 if unknown."""
        self._server.show_stack(self._process)
        os.set_blocking(self._stack, False)
        text, end = "", time.monotonic() + _PATIENCE
        while time.monotonic() < end:
            time.sleep(0.01)
            try:
                text += os.read(self._stack, _FIRST_READ).decode(errors="replace")
            except BlockingIOError:
                continue
            except OSError:
                break
            found = [int(line) for file, line in _FRAME.findall(text) if file == self._file]
            if found:
                return found[0]
        return 0

    def _gone(self) -> ComponentError:
        status = self.close()
        if status == -_SIGXCPU:
            message = "it used up the processor time that a component may use"
            return ComponentError("component.timeout", message, self._file, hint=_TOO_LATE_HINT)
        how, hint = f"by signal {-status}", _CRASHED_HINT
        if status >= 0:
            how, hint = f"with the exit code {status}", _ENDED_HINT
        return ComponentError("component.ended", f"its process ended {how}", self._file, hint=hint)

    def _strange(self) -> ComponentError:
        return self._error("component.ended", "its process wrote something else than an answer", self._file)

    def _raised(self, kind: Any, text: Any, file: Any, line: Any, column: Any) -> ComponentError:
        """Return the component's error. Its place must be in a source file, since findings show the line."""
        place = file if type(file) is str and self._is_source(file) else self._file
        known = place == file
        shown = _line(text)
        message = f"{_line(kind)}: {shown}" if shown else _line(kind)
        return self._error(
            "component.syntax"
            if _line(kind) in ("SyntaxError", "IndentationError", "TabError")
            else "component.raised",
            message,
            place,
            _number(line) if known else 0,
            _number(column) if known else 0,
        )

    def _is_source(self, file: str) -> bool:
        plain = os.path.normpath(file) == file
        return plain and any(file == source or file.startswith(source.rstrip("/") + "/") for source in self._sources)

    def _error(
        self, identifier: str, message: str, file: str, line: int = 0, column: int = 0, hint: str = ""
    ) -> ComponentError:
        self.close()
        return ComponentError(identifier, message, file, line, column, hint)


def _number(value: Any) -> int:
    return value if type(value) is int and 0 <= value <= 1_000_000 else 0


def _line(value: Any) -> str:
    """Return untrusted text on one line, without terminal control characters, and shortened."""
    text = value if type(value) is str else ""
    shown = "".join(c if c.isprintable() else c.encode("unicode_escape", "replace").decode() for c in text)
    return shown if len(shown) <= _LONGEST_TEXT else shown[: _LONGEST_TEXT - 3] + "..."
