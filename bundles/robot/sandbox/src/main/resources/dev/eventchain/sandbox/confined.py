"""Run one Python program with minimal rights. Started by ConfinedProcess, never by hand.

The only argument of :func:`main` is a JSON object: ``work`` (the folder that may be written, and the current one),
``readable`` (paths), ``path`` (for ``sys.path``), ``script`` or ``module``, ``arguments``, ``limits`` (address space,
file size and processor time, open files), ``enclosed`` (true if bubblewrap already confines this process),
``components`` (true if the program calls components, which then run in separate processes), ``turn`` (index among
several such programs, to distribute them over processors), and optionally ``preparation`` with its trusted ``module``
and ``settings`` for its function ``prepare``, which runs before the confinement.
"""

from __future__ import annotations

import contextlib
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
# Libraries and devices that Python opens by itself.
SYSTEM = ("/usr", "/lib", "/lib64", "/lib32", "/bin", "/nix/store", "/etc/ld.so.cache", "/etc/localtime")
DEVICES = ("/dev/null", "/dev/urandom", "/dev/random", "/dev/zero")
OURS = ("audit", "confined", "fork_server", "kernel", "template")


def main(description: str) -> None:
    """Give up rights, then become the program."""
    settings = json.loads(description)
    os.chdir(settings["work"])
    if not settings["enclosed"]:
        os.setsid()  # an interrupt at the terminal is handled by Eventchain, which then ends this process
    settings["readable"] = _places([*settings["readable"], *settings["path"]])
    here, component = os.getpid(), None
    if settings["components"]:
        component = _serve(settings)
    if component is not None:
        import component_process

        for name in ("component_client", "template"):  # of the program and of where this process comes from
            sys.modules.pop(name, None)
        channel, stack = component.settle()
        _give_up_rights(settings, component.folder, here, component.native)
        component_process.run(channel, stack, component.description)
    _prepare(settings)
    parent = here if settings["components"] else None if settings["enclosed"] else settings["parent"]
    _give_up_rights(settings, settings["work"], parent)
    _become(settings)


def _places(readable: list[str]) -> list[str]:
    """Return the real paths of all that may be read, without those inside others: each costs time in each process."""
    every = (*SYSTEM, *DEVICES, sys.prefix, sys.base_prefix, sys.base_exec_prefix, *readable)
    places: list[str] = []
    for path in sorted(set(map(os.path.realpath, every)), key=lambda path: path.split("/")):
        if not (places and path.startswith(places[-1].rstrip("/") + "/")):
            places.append(path)
    return places


def _serve(settings: dict[str, Any]) -> NewProcess | None:
    """Run as the parent of the program and of the processes of its components.

    Returns:
        Nothing in the process of the program, the new process in that of a component. Never in the parent.

    """
    import socket

    import fork_server

    if settings["kernel"]:
        with contextlib.suppress(ImportError):
            import kernel  # noqa: F401  # once, for all processes that give up their rights
        if not settings["enclosed"]:
            die_with_parent(settings["parent"])
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    _take_turns(settings["parent"] + settings["turn"])
    gc.freeze()
    program = os.fork()
    if program == 0:
        ours.close()
        import component_client

        component_client.inherit(theirs)
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
    """Create resources that the confined program cannot create, such as sockets. No untrusted code has run before."""
    if "preparation" in settings:
        import importlib

        before = sys.path
        sys.path = [*settings["path"], *before]
        importlib.import_module(settings["preparation"]["module"]).prepare(settings["preparation"]["settings"])
        sys.path = before


def _take_turns(number: int) -> None:
    """Pin to one processor: program and components alternate, and switching on one processor is twice as fast."""
    processors = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, {processors[number % len(processors)]})


def _give_up_rights(
    settings: dict[str, Any], work: str, parent: int | None, native: tuple[str, ...] | None = None
) -> None:
    """Keep the rights of a program with this writable folder; end with the parent, if the parent may end earlier.

    Args:
        settings: those of :func:`main`.
        work: the folder.
        parent: the parent, None: it does not end earlier.
        native: `audit.native_modules()`, where nothing was imported since. To look for them writes to the page of each
            module's name, which takes long in a process that shares these pages.

    """
    _limit(settings["limits"])
    if settings["kernel"]:
        _ask_kernel(settings["readable"], work, parent)
    for name in audit.native_modules() if native is None else native:
        del sys.modules[name]
    if settings["hooks"]:
        audit.install(settings["readable"], work)


def _limit(limits: dict[str, int]) -> None:
    """Set the limits of one process; the parent limits its wall time."""
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


def die_with_parent(parent: int) -> None:
    """End with this parent, where the kernel can be asked to."""
    try:
        import kernel
    except ImportError:
        return
    kernel.die_with_parent()
    if os.getppid() != parent:
        sys.exit(1)


def _ask_kernel(readable: list[str], work: str, parent: int | None) -> None:
    """Restrict rights through the kernel; without ctypes this is skipped."""
    try:
        import kernel
    except ImportError:
        return
    if parent is not None:
        die_with_parent(parent)
    kernel.restrict_files(readable, [work, "/dev/null"])
    kernel.drop_capabilities()
    kernel.filter_system_calls()


def _become(settings: dict[str, Any]) -> None:
    """Run the program as ``__main__``, with this module hidden from it."""
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
