"""Template of confined processes: an interpreter that has imported what they need, and is forked for each of them.

Started by Java's `Template`, never by hand. This process runs nothing but Eventchain's own code and reads no file of a
user. A fork gets streams and, with bubblewrap, namespaces of its own: bubblewrap makes them for a shell that only
waits, and the fork enters them (setns(2)). It then continues in ``confined.main``, as a new interpreter would.

Requests are lines of JSON on standard input: ``["start", id, bubblewrap, description]``, with the command of bubblewrap
or null, and the text for ``confined.main``. It is answered by ``["refused", id, reason]``, or by ``["made", id,
process, [stdin, stdout, stderr]]``, whose numbers are this process's file descriptors of the other ends. The next line
is then ``["go", id]``: they are open, or ``["drop", id]``: the process shall not start. ``["ended", id, code]`` follows
when it has ended, with 128 plus the number of the signal if one ended it.
"""

from __future__ import annotations

import contextlib
import fcntl
import gc
import json
import os
import select
import shutil
from typing import Any, NamedTuple, NoReturn

import component_client  # noqa: F401  # for the processes
import component_process
import confined
import fork_server

WAITING = ("/bin/sh", "-c", "exec 2>&-; echo; read _")
"""Says when the namespaces are complete, and keeps them until its input ends."""

_MOST_DESCRIPTORS = 4096
_LONGEST_READ = 1 << 16
_HIGH = 64  # more than the descriptors of one process


class Fork(BaseException):
    """Raised in a new process, to discard the frames of the template.

    Args:
        description: the argument of ``confined.main``.

    """

    def __init__(self, description: str) -> None:
        super().__init__()
        self.description = description


class Namespaces(NamedTuple):
    """Namespaces of one process: bubblewrap, the input that keeps them, their first process, and its root folder."""

    bubblewrap: int
    keeper: int
    first: int
    root: tuple[int, int]

    def end(self) -> None:
        """End what is left in them."""
        os.close(self.keeper)
        os.waitpid(self.bubblewrap, 0)


class Started(NamedTuple):
    """A process that has not ended, with a descriptor of it."""

    process: int
    watch: int
    namespaces: Namespaces | None


class Template:
    """Serves one JVM.

    Args:
        requests: file descriptor of the requests.
        answers: file descriptor of the answers.
        path: the folders in which bubblewrap may be, as in ``PATH``.

    """

    def __init__(self, requests: int, answers: int, path: str) -> None:
        self._requests = requests
        self._answers = answers
        self._bubblewrap = shutil.which("bwrap", path=path) or "bwrap"
        self._started: dict[int, Started] = {}
        self._unread = b""

    def serve(self) -> None:
        """Serve until the requests end.

        Raises:
            Fork: in each new process.

        """
        while True:
            poll = select.poll()
            for descriptor in (self._requests, *(started.watch for started in self._started.values())):
                poll.register(descriptor, select.POLLIN)
            # The last read may have brought the next request, too.
            ready = {descriptor for descriptor, _ in poll.poll(0 if b"\n" in self._unread else None)}
            for number, started in list(self._started.items()):
                if started.watch in ready:
                    self._end(number)
            if self._requests in ready or b"\n" in self._unread:
                request = self._read()
                if request is None:
                    return
                if request[0] == "start":  # not what comes too late
                    self._start(*request[1:])

    def _read(self) -> list[Any] | None:
        """Return the next request, None at their end."""
        while b"\n" not in self._unread:
            more = os.read(self._requests, _LONGEST_READ)
            if not more:
                return None
            self._unread += more
        line, _, self._unread = self._unread.partition(b"\n")
        request: list[Any] = json.loads(line)
        return request

    def _say(self, *answer: Any) -> None:
        os.write(self._answers, json.dumps(answer).encode() + b"\n")

    def _start(self, number: int, bubblewrap: list[str] | None, description: str) -> None:
        """Make a process, and let it go when the other ends of its streams are open."""
        pipes = [os.pipe() for _ in range(3)]
        inner = [pipes[0][0], pipes[1][1], pipes[2][1]]
        outer = [pipes[0][1], pipes[1][0], pipes[2][0]]
        wait, go = os.pipe()
        try:
            namespaces = self._make_namespaces(bubblewrap, inner[2]) if bubblewrap else None
            process = _fork(namespaces, [*inner, wait], description)
        except OSError as problem:
            self._say("refused", number, str(problem))
        else:
            self._started[number] = Started(process, os.pidfd_open(process), namespaces)
            self._say("made", number, process, outer)
            if self._read() == ["go", number]:
                os.write(go, b"+")
        for descriptor in (*inner, *outer, wait, go):
            os.close(descriptor)

    def _make_namespaces(self, command: list[str], errors: int) -> Namespaces:
        """Let bubblewrap make the namespaces that its command describes."""
        told, telling = os.pipe()
        kept, keeper = os.pipe()
        complete, completing = os.pipe()
        os.set_inheritable(telling, True)
        line = [*command, "--info-fd", str(telling), "--", *WAITING]
        streams = enumerate((kept, completing, errors))
        bubblewrap = os.posix_spawn(
            self._bubblewrap, line, os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, old, new) for new, old in streams]
        )
        for descriptor in (telling, kept, completing):
            os.close(descriptor)
        first, root = 0, (0, 0)
        if os.read(complete, 1):
            first = int(json.loads(os.read(told, _LONGEST_READ))["child-pid"])
            with contextlib.suppress(OSError):  # then they cannot be entered either
                root = _place(f"/proc/{first}/root/.")
        for descriptor in (told, complete):
            os.close(descriptor)
        return Namespaces(bubblewrap, keeper, first, root)

    def _end(self, number: int) -> None:
        started = self._started.pop(number)
        code = _exit_code(started.process)
        os.close(started.watch)
        if started.namespaces is not None:
            started.namespaces.end()
        self._say("ended", number, code)


def _place(folder: str) -> tuple[int, int]:
    status = os.stat(folder)  # noqa: PTH116  # pathlib would be one more import of all processes
    return status.st_dev, status.st_ino


def _exit_code(process: int) -> int:
    """Wait for the end of a child; return its exit code, or 128 plus the number of the signal that ended it."""
    code = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    return code if code >= 0 else 128 - code


def _fork(namespaces: Namespaces | None, descriptors: list[int], description: str) -> int:
    """Return the process, which is in its namespaces and waits for a byte of the last descriptor.

    Raises:
        Fork: in that process.
        OSError: the namespaces cannot be entered; they have been ended.

    """
    ready, say_ready = os.pipe()
    template = os.getpid()
    process = os.fork()
    if process == 0:
        try:
            settings = _become(namespaces, [*descriptors, say_ready], template, json.loads(description))
        except BaseException:  # must not go on as a second template
            os._exit(1)
        raise Fork(json.dumps(settings))
    os.close(say_ready)
    is_ready = os.read(ready, 1)
    os.close(ready)
    if not is_ready:
        os.waitpid(process, 0)
        if namespaces is not None:
            namespaces.end()
        raise OSError("the namespaces that bubblewrap makes cannot be entered")
    return process


def _become(
    namespaces: Namespaces | None, descriptors: list[int], template: int, settings: dict[str, Any]
) -> dict[str, Any]:
    """Continue as the new process; return the settings for ``confined.main`` when it may start."""
    *_, wait, say_ready = _settle(descriptors)
    confined.die_with_parent(template)
    if namespaces is not None:
        _enter(namespaces)
        os.environ["PWD"] = settings["work"]  # as bubblewrap does
    os.environ.update(HOME=settings["work"], TMPDIR=settings["work"])
    settings["parent"] = template
    os.write(say_ready, b"+")
    if not os.read(wait, 1):
        os._exit(1)
    os.close(wait)
    os.close(say_ready)
    return settings


def _settle(descriptors: list[int]) -> range:
    """Move the descriptors to 0 and what follows, and close all others."""
    high = [fcntl.fcntl(descriptor, fcntl.F_DUPFD, _HIGH) for descriptor in descriptors]
    for wanted, descriptor in enumerate(high):
        os.dup2(descriptor, wanted)
    os.closerange(len(high), _MOST_DESCRIPTORS)
    return range(len(high))


def _enter(namespaces: Namespaces) -> None:
    """Enter the namespaces, without the rights of their owner.

    Returns in a process that is in all of them: that of processes holds only for the children of who enters it.
    """
    import kernel

    kernel.enter_namespaces(namespaces.first)
    if _place("/") != namespaces.root:
        raise OSError("this is another root")
    process = os.fork()
    if process:
        _stand_for(process)
    kernel.drop_capabilities()
    kernel.gain_no_privileges()
    kernel.die_with_parent()
    os.setsid()


def _stand_for(process: int) -> NoReturn:
    """End as the child does."""
    os.closerange(0, _MOST_DESCRIPTORS)
    os._exit(_exit_code(process))


def main(description: str) -> str:
    """Serve as the template; return the argument of ``confined.main`` in each new process.

    Args:
        description: a JSON object: ``parent`` (id of the JVM's process), ``programs`` (the folders in which bubblewrap
            may be, as in ``PATH``), ``path`` (folders with Eventchain's packages), ``modules`` to import besides.

    """
    settings = json.loads(description)
    requests, answers = os.dup(0), os.dup(1)
    nothing = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1):
        os.dup2(nothing, descriptor)
    os.close(nothing)
    os.setsid()  # an interrupt at the terminal is handled by the JVM
    confined.die_with_parent(settings["parent"])
    os.close(os.pidfd_open(os.getpid()))  # fails where processes cannot be watched
    fork_server.import_once([component_process.MESSAGE_OBJECTS, *settings["modules"]], settings["path"])
    gc.collect()
    gc.freeze()
    try:
        Template(requests, answers, settings["programs"]).serve()
    except Fork as fork:
        return fork.description
    os._exit(0)
