"""Work of a node for a campaign: it unpacks program and project once, and runs parts of the campaign.

Ray sends this module to the nodes, where only the standard library can be imported.
"""

from __future__ import annotations

import fcntl
import io
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO

FILES = "{files}"
UNUSED_SECONDS = 7 * 24 * 3600
# For another part that unpacks, and may be one that was stopped.
LOCK_SECONDS = 600
LOCK_PAUSE_SECONDS = 0.1
# The process ends with the worker that starts it, which is killed without notice if the campaign is given up.
BY_ANOTHER_PROGRAM = "import ctypes, os, sys; ctypes.CDLL(None).prctl(1, 9); os.execv(sys.argv[1], sys.argv[1:])"


@dataclass(frozen=True)
class Work:
    """Properties that all parts of a campaign share."""

    program: str  # the name of the pack of the program
    files: str  # the name of the pack of the project
    class_path: list[str]  # names in the program's pack
    java_options: list[str]
    arguments: list[str]  # of the program; ``{files}`` stands for the folder of the unpacked files
    output: str  # the folder of what was generated, in the project's pack
    settings: dict[str, str]  # environment variables
    processors: int


@dataclass(frozen=True)
class Part:
    """Result of a part: its cases, or the output of the program that failed."""

    node: str
    cases: str = ""
    failure: str = ""
    hint: str = ""


def run_part(work: Work, fetch: Callable[[str], bytes], number: int, count: int) -> Part:
    """Simulate a part of a campaign; ``fetch`` returns a pack by its name."""
    node = socket.gethostname()
    java = find_java()
    if java is None:
        return Part(node, failure="There is no Java.", hint="Install Java 17 or later on all nodes, or set JAVA_HOME.")
    try:
        program = unpacked(work.program, fetch)
        files = unpacked(work.files, fetch)
    except OSError as problem:
        return Part(node, failure=f"Program and project cannot be unpacked: {problem}")
    # Beside the packs, where it is removed a week later if the worker is killed.
    with tempfile.TemporaryDirectory(prefix="part-", dir=files.parent) as scratch:
        output = Path(scratch, "out")
        shutil.copytree(files / work.output, output)
        command = [java, *work.java_options, f"-XX:ActiveProcessorCount={work.processors}"]
        command += ["-cp", os.pathsep.join(str(program / name) for name in work.class_path), "dev.eventchain.cli.Main"]
        command += [argument.replace(FILES, str(files)) for argument in work.arguments]
        command += ["--shard", f"{number}/{count}", "-o", str(output)]
        done = run(command, work.settings)
        if done.returncode != 0:
            return Part(node, failure=done.stdout, hint=hint(done.stdout))
        (cases,) = output.glob(f"campaigns/*-{number}-of-{count}/cases.json")
        return Part(node, cases=cases.read_text(encoding="utf-8"))


def find_java() -> str | None:
    """Return the path of Java, as the program's launcher finds it."""
    home = os.environ.get("JAVA_HOME", "")
    if home and os.access(Path(home, "bin", "java"), os.X_OK):
        return str(Path(home, "bin", "java"))
    return shutil.which("java")


def hint(output: str) -> str:
    """Return what to do about the output of a program that failed, if that is about Java."""
    if "UnsupportedClassVersionError" in output:
        return "The Java of the node is too old. Install Java 17 or later on all nodes, or set JAVA_HOME."
    return ""


def run(command: list[str], settings: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """Run the program to its end, in the node's environment without what Ray added to it."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("RAY_", "PYTHON"))}
    return subprocess.run(
        [sys.executable, "-c", BY_ANOTHER_PROGRAM, *command],
        env={**environment, "LC_ALL": "C.UTF-8", **settings},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        check=False,
    )


def unpacked(name: str, fetch: Callable[[str], bytes]) -> Path:
    """Return the folder of an unpacked pack, which is fetched and unpacked once for all parts that run on a node."""
    base = cache_folder() / "ray"
    base.mkdir(parents=True, exist_ok=True)
    folder = base / name
    with (base / "lock").open("w") as lock:
        wait_for(lock)
        if not folder.is_dir():
            remove_unused(base)
            unfinished = Path(tempfile.mkdtemp(prefix="unfinished-", dir=base))
            with zipfile.ZipFile(io.BytesIO(fetch(name))) as archive:
                archive.extractall(unfinished)
            unfinished.rename(folder)
        os.utime(folder)
    return folder


def wait_for(lock: IO[str]) -> None:
    """Lock a file; raise an error if somebody else has had it for too long."""
    end = time.monotonic() + LOCK_SECONDS
    while True:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return
        except BlockingIOError:
            if time.monotonic() > end:
                raise TimeoutError(f"{lock.name} has been locked for {LOCK_SECONDS} s") from None
            time.sleep(LOCK_PAUSE_SECONDS)


def remove_unused(base: Path) -> None:
    """Remove what no part has needed for a week."""
    for folder in base.iterdir():
        if folder.is_dir() and folder.stat().st_mtime < time.time() - UNUSED_SECONDS:
            shutil.rmtree(folder, ignore_errors=True)


def cache_folder() -> Path:
    """Return Eventchain's folder in the user's cache (XDG Base Directory Specification)."""
    configured = os.environ.get("XDG_CACHE_HOME", "")
    base = Path(configured) if Path(configured).is_absolute() else Path("~").expanduser() / ".cache"
    return base / "eventchain"
