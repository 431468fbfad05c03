"""Starts the processes of components for a program that must not start any.

This process runs nothing but Eventchain's own code. It forks the program first, then one process for each component
that the program asks for; each of them gives up its rights before it runs anything foreign, and shares no memory, no
file descriptor but those made for it, and no writable folder with the program or with other components.

Requests are JSON in packets of a Unix socket: ``["start", description]``, answered by the id of the process with the
file descriptors of its channel and of its stack; ``["stack", id]`` and ``["end", id]``, answered by a number.
"""

from __future__ import annotations

import contextlib
import fcntl
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

import component_process

LONGEST_REQUEST = 1 << 18
LOOK_SECONDS = 0.1
"""How long the program waits for a component before it looks at the clocks."""

_BUFFER = 1 << 20
_MOST_DESCRIPTORS = 4096
_HIGH = 64  # beyond what is open
_NUMPY = re.compile(rb"^[ \t]*(?:import|from)[ \t]+numpy\b", re.MULTILINE)


class NewProcess(BaseException):
    """This is the process of a component now: it forgets whatever it was, down to the frames, and gives up its rights.

    Args:
        channel: its end of the channel.
        stack: where it writes its stack.
        folder: its own.
        description: of the component.

    """

    def __init__(self, channel: int, stack: int, folder: str, description: dict[str, Any]) -> None:
        super().__init__()
        self.channel = channel
        self.stack = stack
        self.folder = folder
        self.description = description

    def settle(self) -> tuple[int, int]:
        """Keep nothing open but the channel and the file for the stack, and move into the folder."""
        os.dup2(2, 1)
        high = [fcntl.fcntl(descriptor, fcntl.F_DUPFD, _HIGH) for descriptor in (self.channel, self.stack)]
        for wanted, descriptor in enumerate(high, start=3):
            os.dup2(descriptor, wanted)
        os.closerange(5, _MOST_DESCRIPTORS)
        os.environ.update(HOME=self.folder, TMPDIR=self.folder)
        os.chdir(self.folder)
        return 3, 4


class ForkServer:
    """Serves one program.

    Args:
        control: where requests come from.
        program: id of the program's process.
        work: folder for the folders of the components.
        path: folders with Eventchain's own packages, which nobody else can write.

    """

    def __init__(self, control: socket.socket, program: int, work: Path, path: list[str]) -> None:
        self._control = control
        self._program = program
        self._work = work
        self._path = path
        self._folders: dict[int, Path] = {}
        self._started = 0

    def serve(self) -> int:
        """Serve until the program ends; its exit code, or 128 and the number of the signal that ended it.

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
            raise NewProcess(theirs.detach(), stack_end, str(folder), description)
        self._folders[process] = folder
        descriptors = struct.pack("ii", ours.fileno(), stack)
        self._control.sendmsg([str(process).encode()], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, descriptors)])
        for end in (ours, theirs):
            end.close()
        for descriptor in (stack, stack_end):
            os.close(descriptor)

    def _prepare(self, description: dict[str, Any]) -> None:
        """Import here, once for all processes, what each of them would: NumPy and the classes of messages."""
        wanted = []
        with contextlib.suppress(OSError):
            if _NUMPY.search(Path(description["file"]).read_bytes()):
                wanted.append("numpy")
        if description.get("messages") is not None:
            wanted.append(component_process.MESSAGE_OBJECTS)
        before = sys.path
        # Neither the description's path nor the folder that the program may write: it may be foreign.
        sys.path = [*filter(None, before), *self._path]
        for name in wanted:
            if name not in sys.modules:
                with contextlib.suppress(ImportError):
                    importlib.import_module(name)
        sys.path = before

    def _signal(self, process: int, number: int) -> None:
        if process in self._folders:
            os.kill(process, number)

    def _end(self, process: int) -> int:
        """A process that has ended by itself keeps the exit code that it has."""
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


def _exit_code(status: int) -> int:
    code = os.waitstatus_to_exitcode(status)
    return code if code >= 0 else 128 - code
