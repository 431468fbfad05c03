"""Refuse, through Python's audit hooks, what a confined program must not do (PEP 578).

Audit hooks are a fence, not a wall. They see what the interpreter reports, so native code that opens files or sockets
by itself is out of their sight, and Python code that reaches the hook's own variables can change them (from Python 3.13
on the frames of a traceback allow that). The known ways are closed below; what holds for certain is the kernel
(``kernel.py``) where it has the means. A hook cannot be removed once it is there.
"""

from __future__ import annotations

import os
import posix
import sys
from collections.abc import Callable, Iterable
from typing import Any

REFUSED_PREFIXES = ("socket.", "subprocess.", "os.exec", "os.fork", "os.posix_spawn", "os.spawn", "os.kill", "ctypes.")
REFUSED = frozenset(
    {
        "code.__new__",
        "gc.get_objects",
        "gc.get_referents",
        "gc.get_referrers",
        "os.chdir",
        "os.fchdir",
        "os.link",
        "os.lockf",
        "os.startfile",
        "os.symlink",
        "os.system",
        "pty.spawn",
        "resource.prlimit",
        "resource.setrlimit",
        "signal.pthread_kill",
        "sqlite3.connect",
        "sys._current_exceptions",
        "sys._current_frames",
        "sys.setprofile",
        "sys.settrace",
        "syslog.openlog",
        "syslog.syslog",
    }
)
# Modules whose native code opens files, sockets or processes, or reaches raw memory, without an audit event.
REFUSED_MODULES = (
    *("_ctypes", "ctypes", "_posixsubprocess", "_posixshmem", "_multiprocessing", "_sqlite3", "_dbm", "_gdbm", "apsw"),
    *("readline", "_testcapi", "_testinternalcapi", "_testlimitedcapi", "_xxsubinterpreters", "_interpreters", "cffi"),
)
# Functions that raise no audit event.
SILENT_FUNCTIONS = (
    *("chroot", "lchown", "memfd_create", "mkfifo", "mknod", "nice", "pidfd_open", "sched_setaffinity"),
    *("sched_setscheduler", "setns", "setpriority", "unshare", "eventfd", "fchmod", "fchown", "openpty", "login_tty"),
)
# The arguments of each event that are paths about to change; the rest are numbers.
CHANGES = {
    "os.chflags": 1,
    "os.chmod": 1,
    "os.chown": 1,
    "os.mkdir": 1,
    "os.remove": 1,
    "os.removexattr": 1,
    "os.rename": 2,
    "os.rmdir": 1,
    "os.setxattr": 1,
    "os.truncate": 1,
    "os.utime": 1,
}
FOLDER_DESCRIPTORS = {"os.chmod": 2, "os.mkdir": 2, "os.remove": 1, "os.rename": 2, "os.rmdir": 1, "os.utime": 3}
READS = frozenset({"os.listdir", "os.scandir", "os.listxattr", "os.getxattr"})
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
HARMLESS = frozenset({"/dev/null"})

Hook = Callable[[str, tuple[Any, ...]], None]


def install(readable: Iterable[str], writable: str) -> None:
    """Refuse from now on, for good, all files but these, all sockets and all processes."""
    for name in SILENT_FUNCTIONS:
        for module in (os, posix):
            if hasattr(module, name):
                delattr(module, name)
    for name in REFUSED_MODULES:
        sys.modules[name] = None  # type: ignore[assignment]  # an import then says ModuleNotFoundError
    sys.addaudithook(_hook(tuple(os.path.realpath(path) for path in readable), os.path.realpath(writable)))


def _hook(readable: tuple[str, ...], writable: str) -> Hook:
    # The hook uses locals of this closure only: a program that changes a module's names, or the built-in ones, changes
    # nothing here. Paths are copied to plain strings, because a subclass of str could lie.
    real_path, is_folder, inside, decode = _real_path, _is_folder, _inside, os.fsdecode
    refused, prefixes, modules, harmless = REFUSED, REFUSED_PREFIXES, REFUSED_MODULES, HARMLESS
    changes, descriptors, reads, writing = dict(CHANGES), dict(FOLDER_DESCRIPTORS), READS, WRITING
    is_a, number, text, raw, count_of, refuse, no_module = (
        isinstance,
        int,
        str,
        bytes,
        len,
        PermissionError,
        ImportError,
    )

    def check_path(event: str, path: Any, change: bool) -> None:
        if path is None or (is_a(path, number) and (event == "open" or not change)):
            return  # the current folder, or a file that is open already
        if is_a(path, raw):
            path = decode(b"".join((path,)))
        elif is_a(path, text):
            path = "".join((path,))
        else:
            raise refuse(f"confinement refuses {event} on something that is no path")
        real = real_path(path)
        if inside(real, writable) or real in harmless:
            return
        if change or not [root for root in readable if inside(real, root)]:
            raise refuse(f"confinement refuses {event} on {path}")
        if event == "open" and is_folder(real):
            raise refuse(f"confinement refuses to open the folder {path}")

    def check_change(event: str, arguments: tuple[Any, ...]) -> None:
        for path in arguments[: changes[event]]:
            check_path(event, path, True)
        for descriptor in arguments[descriptors.get(event, count_of(arguments)) :]:
            if is_a(descriptor, number) and descriptor != -1:
                raise refuse(f"confinement refuses {event} relative to a folder descriptor")

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open":
            flags = arguments[2]
            check_path(event, arguments[0], not is_a(flags, number) or flags & writing != 0)
        elif event == "import":
            if is_a(arguments[0], text) and "".join((arguments[0],)).rpartition(".")[2] in modules:
                raise no_module(f"confinement refuses to import {arguments[0]}")
        elif event in changes:
            check_change(event, arguments)
        elif event in reads:
            check_path(event, arguments[0], False)
        elif event in refused or event.startswith(prefixes):
            raise refuse(f"confinement refuses {event}")
        elif event == "object.__setattr__" and arguments[1] == "__code__":
            raise refuse("confinement refuses to replace code")

    return hook


def _inside(path: str, root: str) -> bool:
    return path == root or path.startswith(root if root.endswith("/") else root + "/")


def _is_folder(path: str, stat: Callable[[str], os.stat_result] = posix.stat) -> bool:
    try:
        return stat(path).st_mode & 0o170000 == 0o040000
    except OSError:
        return False


def _real_path(
    path: str,
    read_link: Callable[[str], str] = posix.readlink,
    current_folder: Callable[[], str] = posix.getcwd,
) -> str:
    """As os.path.realpath, by functions that a program cannot replace."""
    pending = (path if path.startswith("/") else current_folder() + "/" + path).split("/")[::-1]
    done: list[str] = []
    links = 0
    while pending:
        part = pending.pop()
        if part in ("", "."):
            continue
        if part == "..":
            if done:
                done.pop()
            continue
        try:
            target = read_link("/".join(["", *done, part]))
        except OSError:
            done.append(part)
            continue
        links += 1
        if links > 40:
            raise PermissionError(f"confinement refuses {path}: too many symbolic links")
        if target.startswith("/"):
            done.clear()
        pending.extend(target.split("/")[::-1])
    return "/" + "/".join(done)
