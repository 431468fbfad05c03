"""Refuse forbidden operations of a confined program through Python's audit hooks (PEP 578).

Audit hooks see only events that the interpreter reports. Native code that opens files or sockets by itself and
hand-made byte code bypass them. Only the kernel (``kernel.py``, bubblewrap) confines reliably, where it is available.
An installed hook cannot be removed.

A program can reach the hook's frames through the traceback of a refusal, and through them all objects that the hook
uses. Therefore these are immutable: the functions of a check have no closure, no global names and no mutable tables.
They use only defaults of parameters, which are numbers, strings, tuples, frozen sets, functions in C, and each other.
Replacing their code or their defaults is refused, too. From Python 3.13 on (PEP 667) the local variables of a frame are
writable. Those of a finished check have no effect, and other threads cannot reach a running check. A signal handler or
a finalizer that runs during a check can.
"""

from __future__ import annotations

import os
import posix
import sys
from collections.abc import Callable, Iterable
from types import CodeType, FunctionType
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
        "sys.monitoring.register_callback",
        "sys.remote_exec",
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
# Functions that raise no audit event. They are removed from this module, so it must not be imported again.
SILENT_MODULE = "posix"
SILENT_FUNCTIONS = (
    *("chroot", "lchown", "memfd_create", "mkfifo", "mknod", "nice", "pidfd_open", "sched_setaffinity"),
    *("sched_setparam", "sched_setscheduler", "setns", "setpgid", "setpriority", "tcsetpgrp", "unshare", "eventfd"),
    *("fchmod", "fchown", "openpty", "login_tty", "sync"),
)
# The number of leading arguments of each event that are paths to be changed, and the index of the first argument
# that is the descriptor of a folder for relative paths.
CHANGES = (
    *(("os.chflags", 1, 9), ("os.chmod", 1, 2), ("os.chown", 1, 9), ("os.mkdir", 1, 2), ("os.remove", 1, 1)),
    *(("os.removexattr", 1, 9), ("os.rename", 2, 2), ("os.rmdir", 1, 1), ("os.setxattr", 1, 9)),
    *(("os.truncate", 1, 9), ("os.utime", 1, 3)),
)
READS = frozenset({"os.listdir", "os.scandir", "os.listxattr", "os.getxattr"})
FREQUENT = frozenset(
    {"builtins.id", "array.__new__", "object.__getattr__", "compile", "exec", "marshal.loads", "sys._getframe"}
)
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
HARMLESS = "/dev/null"
# The commands of fcntl(2) that choose the receiver and the number of a file's signals: F_SETOWN, F_SETSIG, F_SETOWN_EX.
SIGNAL_COMMANDS = (8, 10, 15)

Hook = Callable[[str, tuple[Any, ...]], None]


def native_modules() -> tuple[str, ...]:
    """Return the names of loaded modules that reach raw memory, which confined code must not find."""
    return tuple(name for name in sys.modules if name in ("kernel", "_ctypes") or name.startswith("ctypes"))


def install(readable: Iterable[str], writable: str) -> None:
    """Permanently refuse all files except the given ones, all sockets and all processes.

    Args:
        readable: real paths.
        writable: a folder.

    """
    for name in SILENT_FUNCTIONS:
        for module in (os, posix):
            if hasattr(module, name):
                delattr(module, name)
    for name in REFUSED_MODULES:
        sys.modules[name] = None  # type: ignore[assignment]  # an import then raises ModuleNotFoundError
    sys.addaudithook(_hook(tuple(readable), os.path.realpath(writable)))


def _hook(readable: tuple[str, ...], writable: str) -> Hook:
    inside = _sealed(_inside)
    real_path = _sealed(_real_path, posix.readlink, posix.getcwd, OSError, PermissionError)
    is_folder = _sealed(_is_folder, posix.stat, OSError)
    roots = (readable, writable, HARMLESS)
    kinds = (type, issubclass, int, str, bytes)
    check_path = _sealed(_check_path, real_path, is_folder, inside, *roots, *kinds, PermissionError)
    check_change = _sealed(_check_change, check_path, CHANGES, type, int, PermissionError)
    check_function = _sealed(_check_function, type, FunctionType, _codes(), PermissionError)
    check_import = _sealed(_check_import, type, issubclass, str, (*REFUSED_MODULES, SILENT_MODULE), ImportError)
    checks = (check_path, check_change, check_function, check_import)
    changing = frozenset(event for event, _, _ in CHANGES)
    events = (FREQUENT, changing, READS, REFUSED, REFUSED_PREFIXES)
    return _sealed(_check, *checks, *events, WRITING, SIGNAL_COMMANDS, type, int, PermissionError)


def _sealed(function: Callable[..., Any], *used: Any) -> Callable[..., Any]:
    """Return the function with these objects as defaults of its last parameters, and without global names."""
    code = function.__code__
    return FunctionType(code, {"__builtins__": {}}, code.co_name, used)


def _codes() -> tuple[CodeType, ...]:
    functions = (_check, _check_path, _check_change, _check_function, _check_import, _is_folder, _inside, _real_path)
    return tuple(function.__code__ for function in functions)


# The functions below are sealed. Classes are compared with `is`, or by their true bases, since isinstance would trust
# an object's own claim. A path is copied to a plain string, since a subclass of str could give false values.


def _check(
    event: str,
    arguments: tuple[Any, ...],
    check_path: Callable[..., None],
    check_change: Callable[..., None],
    check_function: Callable[..., None],
    check_import: Callable[..., None],
    frequent: frozenset[str],
    changing: frozenset[str],
    reads: frozenset[str],
    refused: frozenset[str],
    prefixes: tuple[str, ...],
    writing: int,
    signal_commands: tuple[int, ...],
    type_of: Any,
    number: type,
    refuse: type[Exception],
) -> None:
    if event in frequent:
        return
    if event == "open":
        flags = arguments[2]
        check_path(event, arguments[0], type_of(flags) is not number or flags & writing != 0)
    elif event == "import":
        check_import(arguments[0])
    elif event in changing:
        check_change(event, arguments)
    elif event in reads:
        check_path(event, arguments[0], False)
    elif event == "object.__setattr__" or event == "object.__delattr__":
        check_function(arguments[0], arguments[1])
    elif event == "fcntl.fcntl":
        if type_of(arguments[1]) is not number or arguments[1] & 0xFFFFFFFF in signal_commands:
            raise refuse("confinement refuses fcntl for signals")
    elif event in refused or event.startswith(prefixes):
        raise refuse(f"confinement refuses {event}")


def _check_path(
    event: str,
    path: Any,
    change: bool,
    real_path: Callable[[str], str],
    is_folder: Callable[[str], bool],
    inside: Callable[[str, str], bool],
    readable: tuple[str, ...],
    writable: str,
    harmless: str,
    type_of: Any,
    is_kind: Callable[[type, type], bool],
    number: type,
    text: type[str],
    raw: type[bytes],
    refuse: type[Exception],
) -> None:
    if path is None or (is_kind(type_of(path), number) and (event == "open" or not change)):
        return  # the current folder, or an open file
    if type_of(path) is raw:
        path = path.decode("utf-8", "surrogateescape")
    elif is_kind(type_of(path), text):
        path = "".join((path,))
    else:
        raise refuse(f"confinement refuses {event} on something that is not a path")
    real = real_path(path)
    if inside(real, writable) or real == harmless:
        return
    allowed = False
    for root in readable:
        allowed = allowed or inside(real, root)
    if change or not allowed:
        raise refuse(f"confinement refuses {event} on {path}")
    if event == "open" and is_folder(real):
        raise refuse(f"confinement refuses to open the folder {path}")


def _check_change(
    event: str,
    arguments: tuple[Any, ...],
    check_path: Callable[[str, Any, bool], None],
    changes: tuple[tuple[str, int, int], ...],
    type_of: Any,
    number: type,
    refuse: type[Exception],
) -> None:
    for name, paths, descriptors in changes:
        if name != event:
            continue
        for path in arguments[:paths]:
            check_path(event, path, True)
        for descriptor in arguments[descriptors:]:
            if type_of(descriptor) is number and descriptor != -1:
                raise refuse(f"confinement refuses {event} relative to a folder descriptor")


def _check_function(
    changed: Any,
    attribute: str,
    type_of: Any,
    function: type,
    codes: tuple[CodeType, ...],
    refuse: type[Exception],
) -> None:
    if attribute == "__code__":
        raise refuse("confinement refuses to replace code")
    if type_of(changed) is function:
        for code in codes:
            if changed.__code__ is code:
                raise refuse(f"confinement refuses to replace {attribute} of its own functions")


def _check_import(
    name: Any,
    type_of: Any,
    is_kind: Callable[[type, type], bool],
    text: type[str],
    modules: tuple[str, ...],
    refuse: type[Exception],
) -> None:
    if is_kind(type_of(name), text):
        name = "".join((name,))
        if name.rpartition(".")[2] in modules:
            raise refuse(f"confinement refuses to import {name}")


def _inside(path: str, root: str) -> bool:
    return path == root or path.startswith(root if root.endswith("/") else root + "/")


def _is_folder(path: str, stat: Callable[[str], os.stat_result], missing: type[Exception]) -> bool:
    try:
        return stat(path).st_mode & 0o170000 == 0o040000
    except missing:
        return False


def _real_path(
    path: str,
    read_link: Callable[[str], str],
    current_folder: Callable[[], str],
    no_link: type[Exception],
    refuse: type[Exception],
) -> str:
    """Resolve a path as os.path.realpath does, with functions that a program cannot replace."""
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
        except no_link:
            done.append(part)
            continue
        links += 1
        if links > 40:
            raise refuse(f"confinement refuses {path}: too many symbolic links")
        if target.startswith("/"):
            done.clear()
        pending.extend(target.split("/")[::-1])
    return "/" + "/".join(done)
