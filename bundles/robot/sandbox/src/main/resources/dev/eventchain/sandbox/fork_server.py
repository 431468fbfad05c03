"""Starts the processes of components for a program that must not start processes.

This process runs nothing but Eventchain's own code. It forks the program first, then one process for each component
that the program requests. Each process gives up its rights before it runs untrusted code. It shares no memory and no
writable folder with the program or other components, and only the file descriptors made for it.

Requests are JSON in packets of a Unix socket: ``["start", description]``, answered by the id of the process with the
file descriptors of its channel and of its stack; ``["stack", id]`` and ``["end", id]``, answered by a number.
"""

from __future__ import annotations

import contextlib
import fcntl
import gc
import importlib
import json
import os
import re
import shutil
import signal
import socket
import struct
import sys
from pathlib import Path
from typing import Any

import audit
import component_process

LONGEST_REQUEST = 1 << 18
LOOK_SECONDS = 0.1
"""Time for which the program waits for a component before it looks at the clocks."""

_BUFFER = 1 << 20
_MOST_DESCRIPTORS = 4096
_HIGH = 64  # more than can be open
_NUMPY = re.compile(rb"^[ \t]*(?:import|from)[ \t]+numpy\b", re.MULTILINE)


class NewProcess(BaseException):
    """Raised in the new process of a component, to discard the server's frames before it gives up its rights.

    Args:
        channel: file descriptor of its end of the channel.
        stack: file descriptor for its stack.
        folder: its writable folder.
        description: of the component.
        native: names of loaded modules that reach raw memory.

    """

    def __init__(
        self, channel: int, stack: int, folder: str, description: dict[str, Any], native: tuple[str, ...]
    ) -> None:
        super().__init__()
        self.channel = channel
        self.stack = stack
        self.folder = folder
        self.description = description
        self.native = native

    def settle(self) -> tuple[int, int]:
        """Close all files except the channel and the file for the stack, and change to the folder."""
        os.dup2(2, 1)
        high = [fcntl.fcntl(descriptor, fcntl.F_DUPFD, _HIGH) for descriptor in (self.channel, self.stack)]
        for wanted, descriptor in enumerate(high, start=3):
            os.dup2(descriptor, wanted)
        os.closerange(5, _MOST_DESCRIPTORS)
        for name in ("HOME", "TMPDIR"):
            os.environ[name] = self.folder
        os.chdir(self.folder)
        return 3, 4


class ForkServer:
    """Serves one program.

    Args:
        control: socket of the requests.
        program: id of the program's process.
        work: folder for the folders of the components.
        path: folders with Eventchain's own packages, which other users cannot write.

    """

    def __init__(self, control: socket.socket, program: int, work: Path, path: list[str]) -> None:
        self._control = control
        self._program = program
        self._work = work
        self._path = path
        self._folders: dict[int, Path] = {}
        self._started = 0
        self._native = audit.native_modules()

    def serve(self) -> int:
        """Serve until the program ends; return its exit code, or 128 plus the number of the signal that ended it.

        Raises:
            NewProcess: in the process of each component.

        """
        while request := self._control.recv(LONGEST_REQUEST):
            what, argument = json.loads(request)
            if what == "start":
                self._start(argument)
            elif what == "stack":
                self._signal(argument, component_process.SHOW_STACK)
                self._answer(0)
            else:
                self._answer(self._end(argument))
        for process in list(self._folders):
            self._end(process)
        return _exit_code(os.waitpid(self._program, 0)[1])

    def _start(self, description: dict[str, Any]) -> None:
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        stack, stack_end = os.pipe()
        for option in (socket.SO_RCVTIMEO, socket.SO_SNDTIMEO):
            ours.setsockopt(socket.SOL_SOCKET, option, struct.pack("ll", 0, int(LOOK_SECONDS * 1e6)))
        for end in (ours, theirs):
            end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _BUFFER)
        self._prepare(description)
        self._started += 1
        folder = self._work / f"component-{self._started}"
        folder.mkdir(mode=0o700)
        process = os.fork()
        if process == 0:
            for unused in (ours, self._control):
                unused.detach()  # closed soon; a socket that is closed by being forgotten warns first, which takes long
            raise NewProcess(theirs.detach(), stack_end, str(folder), description, self._native)
        self._folders[process] = folder
        descriptors = struct.pack("ii", ours.fileno(), stack)
        self._control.sendmsg([str(process).encode()], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, descriptors)])
        for end in (ours, theirs):
            end.close()
        for descriptor in (stack, stack_end):
            os.close(descriptor)

    def _prepare(self, description: dict[str, Any]) -> None:
        """Import NumPy and the message classes once, before the processes that need them are forked."""
        wanted = []
        with contextlib.suppress(OSError):
            if _NUMPY.search(Path(description["file"]).read_bytes()):
                wanted.append("numpy")
        if description.get("messages") is not None:
            wanted.append(component_process.MESSAGE_OBJECTS)
        # Excludes the description's path and the program's writable folder, which may have untrusted code.
        if import_once(wanted, self._path):
            self._native = audit.native_modules()
            gc.freeze()  # a process that collects garbage would write to the pages that it shares

    def _signal(self, process: int, number: int) -> None:
        if process in self._folders:
            os.kill(process, number)

    def _end(self, process: int) -> int:
        """End a process; one that has ended by itself keeps its exit code."""
        folder = self._folders.pop(process, None)
        if folder is None:
            return 0
        ended, status = os.waitpid(process, os.WNOHANG)
        if not ended:
            os.kill(process, signal.SIGKILL)
            status = os.waitpid(process, 0)[1]
        shutil.rmtree(folder, ignore_errors=True)
        return os.waitstatus_to_exitcode(status)

    def _answer(self, number: int) -> None:
        with contextlib.suppress(OSError):
            self._control.send(str(number).encode())


def import_once(modules: list[str], path: list[str]) -> bool:
    """Import modules that are in these folders or belong to Python, except missing ones; return whether any is new."""
    wanted = [name for name in modules if name not in sys.modules]
    before = sys.path
    sys.path = [*filter(None, before), *path]
    for name in wanted:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)
    sys.path = before
    return bool(wanted)


def _exit_code(status: int) -> int:
    code = os.waitstatus_to_exitcode(status)
    return code if code >= 0 else 128 - code
