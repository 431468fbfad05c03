"""Create Eventchain's own Python environment if necessary, and print its path.

    python3 environment.py [--development] [--cyclonedds | --ray] [--check | --print-executable | --run ARGUMENT...]

The environment is a virtual environment in ``${XDG_CACHE_HOME:-~/.cache}/eventchain/python-<key>``. The key covers the
pinned requirements beside this file and the Python that runs, so a change of either builds a new one and keeps the old
one. Concurrent first runs build it once: the builder holds a lock, and writes the completion marker last, so an
incomplete environment is never used and is rebuilt.

``--development`` adds the tools of the build (ruff, mypy, pytest), and ``--cyclonedds`` Eclipse Cyclone DDS, for nodes
that communicate outside of the simulation; each in a separate environment. ``--ray`` is for the environment that has
Ray and nothing else. ``--check`` creates nothing, and prints ``state: `` with the version of Python and the source of
the packages. It fails where creation would fail: pip downloads the packages into a temporary folder. ``--run
ARGUMENT...`` replaces this process by the environment's Python with these arguments. ``EVENTCHAIN_PYTHON`` names the
base Python; the default is this one, or a newer one of the PATH if this one is too old. ``EVENTCHAIN_WHEELS`` names a
folder of wheels: the packages then come from there only.

Exit code 3: a requirement is missing on this machine; standard error then has lines ``error: `` and ``hint: ``. Exit
code 4 is the same if only Cyclone DDS is unavailable, 6 if only Ray is, and 5 if ``EVENTCHAIN_WHEELS`` lacks a wheel.
Only the standard library is used, and nothing newer than Python 3.7, so that an old Python can still report the error.
"""

from __future__ import annotations

import argparse
import fcntl
import hashlib
import os
import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NoReturn

MINIMUM = (3, 10)
NEWER_NAMES = ("python3.13", "python3.12", "python3.11", "python3.10", "python3.14")
UNAVAILABLE = 3
CYCLONEDDS_UNAVAILABLE = 4
WHEELS_MISSING = 5
RAY_UNAVAILABLE = 6
MARKER = "complete.txt"
HERE = Path(__file__).resolve().parent
CYCLONEDDS = HERE / "requirements-cyclonedds.txt"
RAY = HERE / "requirements-ray.txt"
MIRROR = "point pip to a mirror with PIP_INDEX_URL or PIP_FIND_LINKS, or EVENTCHAIN_WHEELS to a folder of wheels"
ONCE = "; where it exists, allow network access once, or " + MIRROR
WITHOUT_CYCLONEDDS = "its wheel is for Linux on x86_64, macOS and Windows" + ONCE
WITHOUT_RAY = "its wheel is for Linux, macOS and Windows, and for some versions of Python" + ONCE
# Loads the library: an installed wheel may not fit the system's own libraries.
LOAD_CYCLONEDDS = """
import ctypes, os, sys
from cyclonedds.__library__ import library_path
ctypes.CDLL(str(library_path))
print(os.path.realpath(str(library_path)))
"""
# Settings that would make pip or Python search or install outside the new environment.
FOREIGN_SETTINGS = (
    "PYTHONHOME",
    "PYTHONPATH",
    "PYTHONSTARTUP",
    "PIP_TARGET",
    "PIP_PREFIX",
    "PIP_ROOT",
    "PIP_USER",
    "PIP_REQUIRE_VIRTUALENV",
    "PIP_NO_DEPS",
    "__PYVENV_LAUNCHER__",
)


class UnavailableError(Exception):
    """A requirement is missing on this machine: message and hint."""

    def __init__(self, message: str, hint: str, exit_code: int = UNAVAILABLE) -> None:
        super().__init__(message)
        self.hint = hint
        self.exit_code = exit_code


def main(arguments: list[str]) -> int:
    """Run the command line; return the exit code."""
    options = parse(arguments)
    try:
        use_suitable_python(arguments)
        requirements = requirements_of(options)
        if options.check:
            print("state: %s, %s" % (platform.python_version(), outlook(requirements)))
            return 0
        executable = ensure(requirements)
    except UnavailableError as problem:
        print("error: %s" % problem, file=sys.stderr)
        print("hint: %s" % problem.hint, file=sys.stderr)
        return problem.exit_code
    if options.run is not None:
        os.execv(str(executable), [str(executable), *options.run])
    if options.print_executable:
        print(executable)
    return 0


def parse(arguments: list[str]) -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(description="Create Eventchain's Python environment if it is not there yet.")
    parser.add_argument("--development", action="store_true", help="with ruff, mypy and pytest")
    parser.add_argument("--cyclonedds", action="store_true", help="with Eclipse Cyclone DDS")
    parser.add_argument("--ray", action="store_true", help="with Ray only")
    parser.add_argument("--check", action="store_true", help="say what would be done, and whether it can be")
    parser.add_argument("--print-executable", action="store_true", help="print the path of its Python")
    parser.add_argument("--run", nargs=argparse.REMAINDER, help="run its Python with these arguments")
    return parser.parse_args(arguments)


def use_suitable_python(arguments: list[str]) -> None:
    """Continue in the base Python of the environment, replacing this process if that is another one."""
    chosen = os.environ.pop("EVENTCHAIN_PYTHON", "")
    if chosen:
        found = shutil.which(chosen)
        if found is None:
            raise UnavailableError(
                "EVENTCHAIN_PYTHON names %s, which is not an executable file" % chosen,
                "set EVENTCHAIN_PYTHON to a Python 3.10 or newer, or unset it to use python3 of the PATH",
            )
        replace_process(found, arguments)
    if sys.version_info >= MINIMUM:
        return
    for name in NEWER_NAMES:
        found = shutil.which(name)
        if found is not None and runs(found):
            replace_process(found, arguments)
    raise UnavailableError(
        "Python %s (%s) is too old: 3.10 or newer is needed" % (platform.python_version(), sys.executable),
        "install a newer Python, or set EVENTCHAIN_PYTHON to one",
    )


def runs(executable: str) -> bool:
    """Return whether this Python starts (a pyenv shim exists for versions that are not active)."""
    test = "import sys; sys.exit(sys.version_info < %r)" % (MINIMUM,)
    return subprocess.run([executable, "-I", "-c", test], stderr=subprocess.DEVNULL, check=False).returncode == 0


def replace_process(executable: str, arguments: list[str]) -> NoReturn:
    """Run this script with another Python instead."""
    try:
        os.execv(executable, [executable, str(HERE / "environment.py"), *arguments])
    except OSError as problem:
        raise UnavailableError(
            "%s cannot be started: %s" % (executable, problem.strerror),
            "set EVENTCHAIN_PYTHON to a Python 3.10 or newer",
        ) from problem


def requirements_of(options: argparse.Namespace) -> list[Path]:
    """Return the files that name the packages of an environment."""
    if options.ray:
        return [RAY]
    requirements = [HERE / "requirements.txt"]
    if options.development:
        requirements.append(HERE / "requirements-development.txt")
    if options.cyclonedds:
        requirements.append(CYCLONEDDS)
    return requirements


def ensure(requirements: list[Path]) -> Path:
    """Return the Python of the environment, which is created first if it does not exist."""
    folder = folder_of(requirements)
    if not is_complete(folder):
        create_once(folder, requirements)
    return executable_of(folder)


def outlook(requirements: list[Path]) -> str:
    """Return what ``ensure`` would do; raise errors that would stop it."""
    if is_complete(folder_of(requirements)):
        return "packages are there"
    wheels = wheels_folder()
    with tempfile.TemporaryDirectory() as scratch:
        pip = create_empty(Path(scratch) / "environment")
        for file in requirements:
            obtain(pip, ["download", "--dest", str(Path(scratch) / "packages")], [file], wheels)
    if wheels is None:
        return "packages will be fetched by pip at the first use"
    return "packages will be installed from %s at the first use" % wheels


def folder_of(requirements: list[Path]) -> Path:
    """Return the folder of the environment, which need not exist."""
    return cache_folder() / ("python-" + key(requirements))


def cache_folder() -> Path:
    """Return Eventchain's folder in the user's cache (XDG Base Directory Specification)."""
    configured = os.environ.get("XDG_CACHE_HOME", "")
    base = Path(configured) if os.path.isabs(configured) else Path(os.path.expanduser("~")) / ".cache"
    return base / "eventchain"


def key(requirements: list[Path]) -> str:
    """Return 12 hexadecimal digits that depend on the complete content of the environment."""
    digest = hashlib.sha256()
    base = os.path.realpath(getattr(sys, "_base_executable", sys.executable))
    for part in (MARKER, platform.python_implementation(), platform.python_version(), platform.machine(), base):
        digest.update(part.encode() + b"\0")
    for file in requirements:
        digest.update(file.read_bytes() + b"\0")
    return digest.hexdigest()[:12]


def executable_of(folder: Path) -> Path:
    """Return the Python of an environment."""
    return folder / "bin" / "python"


def is_complete(folder: Path) -> bool:
    """Return whether the environment is complete and its base Python is still installed."""
    return (folder / MARKER).is_file() and os.access(executable_of(folder), os.X_OK)


def create_once(folder: Path, requirements: list[Path]) -> None:
    """Create the environment, or wait if another process is creating it."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with open(str(folder) + ".lock", "w", encoding="utf-8") as lock:
            wait_for(lock.fileno())
            if not is_complete(folder):
                shutil.rmtree(folder, ignore_errors=True)
                create(folder, requirements)
    except OSError as problem:
        raise cache_not_writable(folder.parent, problem) from problem


def cache_not_writable(folder: Path, problem: OSError) -> UnavailableError:
    """Return the error for an unusable cache folder."""
    return UnavailableError(
        "the cache folder %s cannot be written: %s" % (folder, problem.strerror or problem),
        "make it writable, or set XDG_CACHE_HOME to a folder that is",
    )


def wait_for(lock: int) -> None:
    """Take the lock; report a wait. The system releases the lock when its holder ends."""
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        report("waiting for another process that creates the Python environment")
        fcntl.flock(lock, fcntl.LOCK_EX)


def create(folder: Path, requirements: list[Path]) -> None:
    """Create the environment in its final place (a virtual environment cannot be moved), marker last."""
    wheels = wheels_folder()
    report("creating the Python environment %s (once)" % folder)
    pip = create_empty(folder)
    facts = [("version", platform.python_version()), ("prefix", sys.base_prefix), ("libraries", sys.base_exec_prefix)]
    if CYCLONEDDS in requirements:
        facts.append(("cyclonedds", install_cyclonedds(folder, pip, wheels)))
    obtain(pip, ["install"], [file for file in requirements if file != CYCLONEDDS], wheels)
    unfinished = folder / (MARKER + ".new")
    unfinished.write_text("".join("%s=%s\n" % fact for fact in facts), encoding="utf-8")
    os.replace(unfinished, folder / MARKER)


def install_cyclonedds(folder: Path, pip: list[str], wheels: Path | None) -> str:
    """Install Cyclone DDS first, since it may be unavailable here; return the path of its library, libddsc."""
    obtain(pip, ["install"], [CYCLONEDDS], wheels)
    return run(
        [str(executable_of(folder)), "-c", LOAD_CYCLONEDDS],
        "the library of Eclipse Cyclone DDS cannot be loaded",
        "use a system that the wheel of cyclonedds is made for, such as Linux on x86_64 with the GNU C library",
        CYCLONEDDS_UNAVAILABLE,
    ).splitlines()[-1]


def wheels_folder() -> Path | None:
    """Return the folder that packages come from; None: from pip's index."""
    named = os.environ.get("EVENTCHAIN_WHEELS", "")
    if not named:
        return None
    if not os.path.isdir(named):
        raise UnavailableError(
            "EVENTCHAIN_WHEELS names %s, which is not a folder" % named,
            "name a folder of wheels, or unset it to let pip fetch the packages",
            WHEELS_MISSING,
        )
    return Path(named).resolve()


def obtain(pip: list[str], action: list[str], requirements: list[Path], wheels: Path | None) -> None:
    """Make pip install or download exactly the packages that the files name."""
    command = pip_command(pip, action, wheels)
    for file in requirements:
        command += ["-r", str(file)]
    try:
        if CYCLONEDDS in requirements:
            run(command, "Eclipse Cyclone DDS cannot be installed", WITHOUT_CYCLONEDDS, CYCLONEDDS_UNAVAILABLE)
        elif RAY in requirements:
            run(command, "Ray cannot be installed", WITHOUT_RAY, RAY_UNAVAILABLE)
        else:
            run(command, "the Python packages cannot be installed", "allow network access once, or " + MIRROR)
    except UnavailableError as problem:
        if wheels is not None:
            require_wheels(pip, requirements, wheels, problem)
        raise


def pip_command(pip: list[str], action: list[str], wheels: Path | None) -> list[str]:
    """Return the pip command with the common options: only from the folder of wheels, if there is one."""
    command = [*pip, *action, "--no-deps", "--prefer-binary", "--no-input", "--quiet", "--retries", "2"]
    if wheels is not None:
        command += ["--isolated", "--no-index", "--find-links", str(wheels), "--only-binary", ":all:"]
    return command


def require_wheels(pip: list[str], requirements: list[Path], wheels: Path, problem: UnavailableError) -> None:
    """Report all packages without a fitting wheel in the folder; pip itself reports only the first."""
    lines = [line for file in requirements for line in file.read_text(encoding="utf-8").splitlines()]
    with tempfile.TemporaryDirectory() as scratch:
        download = pip_command(pip, ["download", "--dest", scratch], wheels)
        lacking = [
            line.partition(";")[0].strip()
            for line in lines
            if line and line[0] not in "#-" and not succeeds([*download, line])
        ]
    if lacking:
        raise UnavailableError(
            "the folder %s of EVENTCHAIN_WHEELS has no wheel for this Python of %s" % (wheels, ", ".join(lacking)),
            "on a machine with a network, the same system and Python %d.%d: "
            "pip download --no-deps --only-binary :all: --dest FOLDER %s; or unset EVENTCHAIN_WHEELS"
            % (sys.version_info[0], sys.version_info[1], " ".join(lacking)),
            WHEELS_MISSING,
        ) from problem


def succeeds(command: list[str]) -> bool:
    """Return whether a command succeeds."""
    return subprocess.run(command, env=clean_settings(), capture_output=True, check=False).returncode == 0


def create_empty(folder: Path) -> list[str]:
    """Create the virtual environment; return the pip command that installs into it."""
    missing = "install Python's venv module and pip (Debian, Ubuntu: apt-get install python3-venv)"
    if not has_module("venv"):
        raise UnavailableError("%s has no venv module" % sys.executable, missing)
    if has_module("ensurepip"):
        run([sys.executable, "-m", "venv", str(folder)], "the virtual environment cannot be created", missing)
        return [str(executable_of(folder)), "-m", "pip"]
    if not has_module("pip"):
        raise UnavailableError("%s has neither the ensurepip module nor pip" % sys.executable, missing)
    run(
        [sys.executable, "-m", "venv", "--without-pip", str(folder)],
        "the virtual environment cannot be created",
        missing,
    )
    return [sys.executable, "-m", "pip", "--python", str(executable_of(folder))]


def has_module(name: str) -> bool:
    """Return whether this Python can import the module (Debian splits its standard library into packages)."""
    command = [sys.executable, "-c", "import " + name]
    return subprocess.run(command, env=clean_settings(), stderr=subprocess.DEVNULL, check=False).returncode == 0


def run(command: list[str], failure: str, hint: str, exit_code: int = UNAVAILABLE) -> str:
    """Run a command and return its output; on failure, report the end of the output."""
    done = subprocess.run(
        command,
        env=clean_settings(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    if done.returncode != 0:
        lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        errors = [line for line in lines if line.startswith("ERROR")] or lines[-3:]
        raise UnavailableError(
            "%s: %s" % (failure, " ".join(errors) or "exit code %d" % done.returncode), hint, exit_code
        )
    return done.stdout


def clean_settings() -> dict[str, str]:
    """Return the user's environment without variables that redirect pip; proxies and mirrors stay."""
    settings = {name: value for name, value in os.environ.items() if name not in FOREIGN_SETTINGS}
    settings["PIP_DISABLE_PIP_VERSION_CHECK"] = "1"
    return settings


def report(message: str) -> None:
    """Show progress."""
    print(message, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
