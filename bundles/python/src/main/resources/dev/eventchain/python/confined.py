"""Run one Python program with as few rights as it needs. Started by ConfinedProcess, never by hand.

The only argument of :func:`main` is a JSON object: ``work`` (the folder that may be written, and the current one),
``readable`` (paths), ``path`` (for ``sys.path``), ``script`` or ``module``, ``arguments``, ``limits`` (address space,
file size and processor time, open files) and ``enclosed`` (whether bubblewrap holds this process already).
"""

from __future__ import annotations

import json
import os
import resource
import sys

import audit

SECONDS_TO_CLEAN_UP = 1
# Libraries and the devices that Python opens by itself.
SYSTEM = ("/usr", "/lib", "/lib64", "/lib32", "/bin", "/nix/store", "/etc/ld.so.cache", "/etc/localtime")
DEVICES = ("/dev/null", "/dev/urandom", "/dev/random", "/dev/zero")


def main(description: str) -> None:
    """Give up rights, then become the program."""
    settings = json.loads(description)
    os.chdir(settings["work"])
    _limit(settings["limits"])
    readable = [*SYSTEM, *DEVICES, sys.prefix, sys.base_prefix, sys.base_exec_prefix, *settings["readable"]]
    readable += settings["path"]
    if not settings["enclosed"]:
        os.setsid()  # an interrupt at the terminal is for Eventchain, which then ends this process
    if settings["kernel"]:
        _ask_kernel(readable, settings)
    if settings["hooks"]:
        audit.install(readable, settings["work"])
    _become(settings)


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


def _ask_kernel(readable: list[str], settings: dict[str, object]) -> None:
    """Use what the kernel offers; a Python without ctypes cannot ask."""
    try:
        import kernel
    except ImportError:
        return
    if not settings["enclosed"]:
        kernel.die_with_parent()
        if os.getppid() != settings["parent"]:
            sys.exit(1)
        kernel.restrict_files(readable, [str(settings["work"]), "/dev/null"])
    kernel.drop_capabilities()
    kernel.filter_system_calls()
    for name in [name for name in sys.modules if name in ("kernel", "_ctypes") or name.startswith("ctypes")]:
        del sys.modules[name]


def _become(settings: dict[str, list[str]]) -> None:
    """Run the program as ``__main__``, with this module out of its sight."""
    import runpy

    program = settings.get("script")
    sys.argv = [str(program or settings["module"]), *settings["arguments"]]
    here = __file__.rpartition("/")[0]
    sys.path[:] = [*settings["path"], *(entry for entry in sys.path if entry not in ("", here))]
    for name in ("confined", "audit"):
        sys.modules.pop(name, None)
    if program:
        runpy.run_path(str(program), run_name="__main__")
    else:
        runpy.run_module(str(settings["module"]), run_name="__main__", alter_sys=True)
