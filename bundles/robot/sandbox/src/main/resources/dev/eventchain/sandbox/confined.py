"""Run one Python program with as few rights as it needs. Started by ConfinedProcess, never by hand.

The only argument of :func:`main` is a JSON object: ``work`` (the folder that may be written, and the current one),
``readable`` (paths), ``path`` (for ``sys.path``), ``script`` or ``module``, ``arguments``, ``limits`` (address space,
file size and processor time, open files), ``enclosed`` (whether bubblewrap holds this process already),
``components`` (whether the program calls components, which then live in processes of their own), ``turn`` (which of
several such programs this is, so that they do not meet on one processor), and perhaps ``preparation`` with its
``module``, one of ours, and ``settings`` for its function ``prepare``, which runs ahead of the confinement.
"""

from __future__ import annotations

import gc
import json
import os
import resource
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import audit

if TYPE_CHECKING:
    from fork_server import NewProcess

SECONDS_TO_CLEAN_UP = 1
# Libraries and the devices that Python opens by itself.
SYSTEM = ("/usr", "/lib", "/lib64", "/lib32", "/bin", "/nix/store", "/etc/ld.so.cache", "/etc/localtime")
DEVICES = ("/dev/null", "/dev/urandom", "/dev/random", "/dev/zero")
OURS = ("audit", "confined", "fork_server", "kernel")


def main(description: str) -> None:
    """Give up rights, then become the program."""
    settings = json.loads(description)
    os.chdir(settings["work"])
    if not settings["enclosed"]:
        os.setsid()  # an interrupt at the terminal is for Eventchain, which then ends this process
    here, component = os.getpid(), None
    if settings["components"]:
        component = _serve(settings)
    if component is not None:
        import component_process

        channel, stack = component.settle()
        _give_up_rights(settings, component.folder, here)
        component_process.run(channel, stack, component.description)
    _prepare(settings)
    parent = here if settings["components"] else None if settings["enclosed"] else settings["parent"]
    _give_up_rights(settings, settings["work"], parent)
    _become(settings)


def _serve(settings: dict[str, Any]) -> NewProcess | None:
    """Be the parent of the program and of the processes of its components.

    Returns:
        In the process of the program nothing, in that of a component what it is. In the parent never.

    """
    import socket

    import fork_server

    if settings["kernel"] and not settings["enclosed"]:
        _die_with_parent(settings["parent"])
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    _take_turns(settings["parent"] + settings["turn"])
    gc.freeze()
    program = os.fork()
    if program == 0:
        ours.close()
        os.environ["EVENTCHAIN_FORK_SERVER"] = str(theirs.detach())
        import component_client  # noqa: F401  # takes the socket before it could no longer be made

        return None
    theirs.close()
    nothing = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1):
        os.dup2(nothing, descriptor)
    try:
        os._exit(fork_server.ForkServer(ours, program, Path(settings["work"]), settings["path"]).serve())
    except fork_server.NewProcess as new:
        return new.with_traceback(None)


def _prepare(settings: dict[str, Any]) -> None:
    """Make what the program needs and could not make any more, such as sockets. Nothing foreign has run by then."""
    if "preparation" in settings:
        import importlib

        before = sys.path
        sys.path = [*settings["path"], *before]
        importlib.import_module(settings["preparation"]["module"]).prepare(settings["preparation"]["settings"])
        sys.path = before


def _take_turns(number: int) -> None:
    """Stay on one processor: program and components work in turn, and waking each other there is twice as fast."""
    processors = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {processors[number % len(processors)]})


def _give_up_rights(settings: dict[str, Any], work: str, parent: int | None) -> None:
    """Keep what a program with this writable folder needs; end with the parent, if there is one to end with."""
    _limit(settings["limits"])
    readable = [*SYSTEM, *DEVICES, sys.prefix, sys.base_prefix, sys.base_exec_prefix, *settings["readable"]]
    readable += settings["path"]
    if settings["kernel"]:
        _ask_kernel(readable, work, parent)
    if settings["hooks"]:
        audit.install(readable, work)


def _limit(limits: dict[str, int]) -> None:
    """Set what one process may use; the parent limits how long it may take."""
    seconds = limits["cpuSeconds"]
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + SECONDS_TO_CLEAN_UP))
    for kind, amount in (
        (resource.RLIMIT_AS, limits["memory"]),
        (resource.RLIMIT_FSIZE, limits["fileSize"]),
        (resource.RLIMIT_NOFILE, limits["openFiles"]),
        (resource.RLIMIT_CORE, 0),
    ):
        _, hard = resource.getrlimit(kind)
        lowest = amount if hard == resource.RLIM_INFINITY else min(amount, hard)
        resource.setrlimit(kind, (lowest, lowest))


def _die_with_parent(parent: int) -> None:
    try:
        import kernel
    except ImportError:
        return
    kernel.die_with_parent()
    if os.getppid() != parent:
        sys.exit(1)


def _ask_kernel(readable: list[str], work: str, parent: int | None) -> None:
    """Use what the kernel offers; a Python without ctypes cannot ask."""
    try:
        import kernel
    except ImportError:
        return
    if parent is not None:
        _die_with_parent(parent)
    kernel.restrict_files(readable, [work, "/dev/null"])
    kernel.drop_capabilities()
    kernel.filter_system_calls()
    for name in [name for name in sys.modules if name in ("kernel", "_ctypes") or name.startswith("ctypes")]:
        del sys.modules[name]


def _become(settings: dict[str, Any]) -> None:
    """Run the program as ``__main__``, with this module out of its sight."""
    import runpy

    program = settings.get("script")
    sys.argv = [str(program or settings["module"]), *settings["arguments"]]
    here = __file__.rpartition("/")[0]
    sys.path[:] = [*settings["path"], *(entry for entry in sys.path if entry not in ("", here))]
    for name in OURS:
        sys.modules.pop(name, None)
    if program:
        runpy.run_path(str(program), run_name="__main__")
    else:
        runpy.run_module(str(settings["module"]), run_name="__main__", alter_sys=True)
