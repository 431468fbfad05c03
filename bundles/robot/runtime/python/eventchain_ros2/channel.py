"""Frames over a pair of streams, between a host of nodes and its driver; this bundle's README describes them."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import struct
import sys
from enum import IntEnum
from io import RawIOBase
from typing import Any, BinaryIO

from eventchain_ros2.failures import HostError
from eventchain_ros2.simulation import LimitError

LONGEST_FRAME = 1 << 25
"""Bytes."""

_PIPE_BYTES = 1 << 18
_FRAME = struct.Struct("<IB")


class Kind(IntEnum):
    """Kinds of frames."""

    CONFIGURE = 1
    READY = 2
    STEP = 3
    STEPPED = 4
    FINISH = 5
    FINISHED = 6
    FAILED = 7
    RESET = 8
    CONNECT = 9
    CONNECTED = 10
    PUBLISH = 11
    RUN = 12
    IDLE = 13
    START = 14
    STOP = 15


def _widen(pipe: int) -> None:
    """Let a pipe hold a step with a point cloud, where the system can: no side waits for the other one half-way."""
    command = getattr(fcntl, "F_SETPIPE_SZ", None)
    if command is not None:
        with contextlib.suppress(OSError):  # it is no pipe, or one too many of this size
            fcntl.fcntl(pipe, command, _PIPE_BYTES)


class Channel:
    """Reads and writes frames."""

    def __init__(self, source: RawIOBase, target: BinaryIO) -> None:
        self._source = source
        self._target = target

    @classmethod
    def of_standard_streams(cls) -> Channel:
        """Take over standard input and output, so that user code cannot access them: it prints to standard error."""
        source, target = os.fdopen(os.dup(0), "rb", 0), os.fdopen(os.dup(1), "wb")
        _widen(0)
        _widen(1)
        nothing = os.open(os.devnull, os.O_RDONLY)
        os.dup2(nothing, 0)
        os.dup2(2, 1)
        sys.stdout = sys.stderr
        return cls(source, target)

    def fileno(self) -> int:
        """Return the file descriptor that is readable when a frame arrives."""
        return self._source.fileno()

    def read(self) -> tuple[int, memoryview] | None:
        """Return the next frame, or None at the end."""
        head = self._read(_FRAME.size)
        if not head:
            return None
        if len(head) == _FRAME.size:
            length, kind = _FRAME.unpack(head)
            if not 1 <= length <= LONGEST_FRAME:
                raise HostError("protocol.frame", f"a frame cannot have {length} bytes")
            payload = self._read(length - 1)
            if len(payload) == length - 1:
                return kind, memoryview(payload)
        raise HostError("protocol.frame", "the input ended within a frame")

    def _read(self, length: int) -> bytearray:
        """Return this number of bytes, or fewer at the end."""
        data = bytearray(length)
        position = 0
        with memoryview(data) as view:
            while position < length:
                count = self._source.readinto(view[position:])
                if not count:
                    break
                position += count
        return data[:position] if position < length else data

    def write(self, kind: Kind, *payload: bytes | bytearray | memoryview) -> None:
        """Write a frame."""
        length = 1 + sum(map(len, payload))
        if length > LONGEST_FRAME:
            raise LimitError(f"what is to be said of the scenario is longer than {LONGEST_FRAME >> 20} MiB")
        self._target.write(b"".join((_FRAME.pack(length, kind), *payload)))
        self._target.flush()

    def write_json(self, kind: Kind, value: Any) -> None:
        """Write a frame of JSON."""
        self.write(kind, json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode(errors="replace"))
