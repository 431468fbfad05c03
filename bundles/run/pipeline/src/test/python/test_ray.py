"""Tests what the driver of a Ray cluster and its nodes do, without Ray."""

from __future__ import annotations

import fcntl
import io
import itertools
import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import driver
import node
import packs
import pytest


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache"


def write(file: Path, text: str = "") -> Path:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return file


def test_a_pack_is_the_same_for_the_same_files(tmp_path: Path) -> None:
    for copy in ("one", "two"):
        write(tmp_path / copy / "b" / "c.txt", "c")
        write(tmp_path / copy / "a.jar", "a")
    one, two = (packs.pack(packs.program([tmp_path / copy, tmp_path / copy / "a.jar"])) for copy in ("one", "two"))
    assert one.content != two.content, "the name of an entry is a part of the program's identity"
    (tmp_path / "one" / "a.jar").touch()
    assert one == packs.pack(packs.program([tmp_path / "one", tmp_path / "one" / "a.jar"]))
    with zipfile.ZipFile(io.BytesIO(one.content)) as archive:
        assert archive.namelist() == ["000/one/a.jar", "000/one/b/c.txt", "001/a.jar"]


def test_links_are_followed_and_results_left_out(tmp_path: Path) -> None:
    project = tmp_path / "project"
    write(project / "eventchain.yaml")
    write(project / "out" / "campaigns" / "cases.csv")
    write(project / ".git" / "config")
    write(project / "components" / ".venv" / "secret")
    write(project / "components" / "a.py")
    write(tmp_path / "elsewhere" / "base.json")
    (project / "software-base").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "elsewhere" / "circle").symlink_to(project)
    table = write(tmp_path / "table.csv")
    found = packs.project([table], [packs.Folder(project, frozenset([project / "out"]), hidden=False)])
    names = {name.removeprefix(str(tmp_path).lstrip("/")) for name in found}
    assert names == {
        "/table.csv",
        "/project/eventchain.yaml",
        "/project/components/a.py",
        "/project/software-base/base.json",
    }


def test_a_pack_is_unpacked_once_and_removed_a_week_later(cache: Path, tmp_path: Path) -> None:
    fetched: list[str] = []
    content = packs.pack({"a.txt": write(tmp_path / "a.txt", "a")}).content

    def fetch(name: str) -> bytes:
        fetched.append(name)
        return content

    for name in ("old", "old", "new"):
        assert (node.unpacked(name, fetch) / "a.txt").read_text() == "a"
    assert fetched == ["old", "new"]
    os.utime(cache / "eventchain" / "ray" / "old", (0, 0))
    node.unpacked("newer", fetch)
    assert sorted(entry.name for entry in (cache / "eventchain" / "ray").iterdir()) == ["lock", "new", "newer"]


def part_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> node.Part:
    """Run a part with a shell script as Java."""
    java = write(tmp_path / "jdk" / "bin" / "java", "#!/bin/sh\n" + script)
    java.chmod(0o755)
    monkeypatch.setenv("JAVA_HOME", str(tmp_path / "jdk"))
    monkeypatch.setenv("RAY_AUTH_TOKEN", "secret")
    project = tmp_path / "project"
    write(project / "eventchain.yaml", "name: x")
    write(project / "out" / "chain.json")
    files = packs.pack(packs.project([], [packs.Folder(project)]))
    program = packs.pack({"000/a.jar": write(tmp_path / "a.jar")})
    content = {each.name: each.content for each in (files, program)}
    work = node.Work(
        program.name,
        files.name,
        ["000/a.jar"],
        ["-Xmx1g"],
        ["campaign", node.FILES + str(project)],
        packs.place(project / "out"),
        {"EVENTCHAIN_CONFINEMENT": "audit-hooks"},
        2,
    )
    return node.run_part(work, content.__getitem__, 2, 5)


REHEARSAL = """
while [ "$1" != campaign ]; do said="$said $1"; shift; done
test -e "$2/eventchain.yaml" && test -e "$6/chain.json" && test "$3 $4 $5" = "--shard 2/5 -o" || exit 9
mkdir -p "$6/campaigns/approach-2-of-5"
echo "$said $EVENTCHAIN_CONFINEMENT <$RAY_AUTH_TOKEN>" > "$6/campaigns/approach-2-of-5/cases.json"
"""


def test_a_part_has_project_output_and_settings_and_not_the_token(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    part = part_of(tmp_path, monkeypatch, REHEARSAL)
    assert part.failure == ""
    assert part.cases.startswith(" -Xmx1g -XX:ActiveProcessorCount=2 -cp " + str(cache))
    assert part.cases.endswith("/000/a.jar dev.eventchain.cli.Main audit-hooks <>\n")


def test_a_part_that_fails_says_why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    part = part_of(tmp_path, monkeypatch, "echo 'a.yaml:3:1: error: No. [x.y]'; echo '1 error'; exit 2")
    assert driver.telling(part.failure) == "a.yaml:3:1: error: No. [x.y]"
    old = "echo 'java.lang.UnsupportedClassVersionError: Main'; exit 1"
    assert "17 or later" in part_of(tmp_path, monkeypatch, old).hint
    monkeypatch.setenv("PATH", "/nowhere")
    monkeypatch.delenv("JAVA_HOME")
    lacking = node.run_part(None, None, 1, 2)  # type: ignore[arg-type]
    assert lacking.failure == "There is no Java."


def test_all_processors_are_used() -> None:
    def nodes(*counts: int) -> list[dict[str, Any]]:
        return [{"Alive": True, "Resources": {"CPU": float(count)} if count else {}} for count in counts]

    assert driver.capacity(nodes(2)) == (1, 2)
    assert driver.capacity(nodes(0, 4, 9)) == (3, 4)
    assert driver.capacity(nodes(64, 64)) == (16, 8)
    assert driver.capacity([*nodes(2), {"Alive": False, "Resources": {"CPU": 1.0}}]) == (1, 2)
    with pytest.raises(driver.DriverError, match="No node"):
        driver.capacity(nodes(0))


class Tasks:
    """Tasks that end at once, the last one first; some of them come late, and some never."""

    def __init__(self, failing: int = 0, late: int = 0, lost: frozenset[int] = frozenset()) -> None:
        self.failing = failing
        self.late = late
        self.lost = lost
        self.most = 0
        self.reason = ""

    def start(self, number: int) -> int:
        return number

    def wait(self, started: list[int]) -> list[int]:
        self.most = max(self.most, len(started))
        return [number for number in started if number not in self.lost][-1:]

    def idle(self) -> str:
        return self.reason

    def result(self, number: int, done: int) -> node.Part | None:
        if number == self.late:
            self.late = 0
            return None
        return node.Part("n1", failure="no\nspace left") if number == self.failing else node.Part("n1", f"cases {done}")


def minutes() -> Callable[[], float]:
    """Return a clock that goes on by a minute whenever it is looked at."""
    return (60.0 * minute for minute in itertools.count()).__next__


def run(tasks: Tasks, clock: Callable[[], float] = lambda: 0.0) -> list[dict[str, Any]]:
    """Run 30 parts for a program that waits for them."""
    source, program = os.pipe()
    target = io.StringIO()
    try:
        channel = driver.Channel(os.fdopen(source), target)
        watch = driver.Watch(tasks, channel, clock)  # type: ignore[arg-type]
        driver.run(tasks, list(range(1, 31)), 2, channel, watch)  # type: ignore[arg-type]
    finally:
        os.close(program)
    return [json.loads(line) for line in target.getvalue().splitlines()]


def test_each_part_is_answered_once() -> None:
    tasks = Tasks(late=30)
    answers = run(tasks)
    assert sorted(each["part"] for each in answers) == list(range(1, 31))
    assert all(each["cases"] == f"cases {each['part']}" for each in answers)
    assert tasks.most == 8


def test_a_part_that_fails_ends_all() -> None:
    with pytest.raises(driver.DriverError, match="Part 20 failed on the node n1: space left"):
        run(Tasks(20))


def test_parts_that_nobody_works_on_end_all() -> None:
    tasks = Tasks(lost=frozenset([7]))
    tasks.reason = "no node is left"
    with pytest.raises(driver.DriverError, match="Nobody has worked on the campaign for 300 s: no node is left"):
        run(tasks, minutes())


def test_a_part_that_takes_long_is_waited_for() -> None:
    tasks = Tasks(lost=frozenset([7]))
    looks = iter(range(100))

    def idle() -> str:
        if next(looks) == 99:
            tasks.lost = frozenset()
        return ""

    tasks.idle = idle  # type: ignore[method-assign]
    answers = run(tasks, minutes())
    assert answers[-1]["part"] == 7
    assert {"alive": True} in answers


class Ray:
    """Nodes of a cluster, and how many of their processors are free."""

    def __init__(self, free: float, *counts: float) -> None:
        self.free = free
        self.counts = counts

    def nodes(self) -> list[dict[str, Any]]:
        dead = {"Alive": False, "Resources": {"CPU": 64.0}}
        return [dead, *({"Alive": True, "Resources": {"CPU": count}} for count in self.counts)]

    def available_resources(self) -> dict[str, float]:
        return {"CPU": self.free} if self.free else {}


@pytest.mark.parametrize(
    ("ray", "reason"),
    [
        (Ray(0, 2, 2), ""),
        (Ray(3, 2, 2), ""),
        (Ray(4, 2, 2), "no part runs, though all 4 processors are free"),
        (Ray(1, 1), "no node with 2 processors is left"),
        (Ray(0), "no node with 2 processors is left"),
    ],
)
def test_a_cluster_is_idle_if_nothing_runs_or_can_run(ray: Ray, reason: str) -> None:
    tasks = driver.Tasks.__new__(driver.Tasks)
    tasks._ray = ray
    tasks._work = node.Work("", "", [], [], [], "", {}, 2)
    assert tasks.idle() == reason


WAITING = """
import io, sys, time
import driver
channel = driver.Channel(io.StringIO(), sys.stdout)
with channel.limited("it was asked", 60):
    pass
with channel.limited("it was asked", 0.01):
    time.sleep(600)
"""


def test_a_step_without_an_answer_ends_the_driver() -> None:
    path = os.pathsep.join([str(Path(driver.__file__).parent), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run(
        [sys.executable, "-c", WAITING], env={**os.environ, "PYTHONPATH": path}, capture_output=True, check=False
    )
    assert done.returncode == 1
    assert json.loads(done.stdout)["error"] == "Ray has not answered for 0.01 s, while it was asked"


def test_a_lock_that_somebody_keeps_is_a_failure(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(node, "LOCK_SECONDS", 0)
    monkeypatch.setenv("JAVA_HOME", str(write(cache / "jdk" / "bin" / "java").parents[1]))
    (cache / "jdk" / "bin" / "java").chmod(0o755)
    lock = write(cache / "eventchain" / "ray" / "lock")
    with lock.open("w") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        part = node.run_part(node.Work("p", "f", [], [], [], "", {}, 1), lambda name: b"", 1, 2)
    assert part.failure == f"Program and project cannot be unpacked: {lock} has been locked for 0 s"


def test_the_end_of_the_program_ends_all() -> None:
    channel = driver.Channel(io.StringIO('{"count": 1}\n'), io.StringIO())
    assert channel.receive() == {"count": 1}
    with pytest.raises(EOFError):
        channel.receive()
    with pytest.raises(EOFError):
        driver.run(Tasks(), [1], 1, channel, driver.Watch(Tasks(), channel))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("address", "reason"),
    [("ray://head:10001", "Ray Client"), ("127.0.0.1:9", "no Ray cluster at '127.0.0.1:9'"), ("host:port", "no Ray")],
)
def test_an_address_without_a_cluster_is_refused_at_once(address: str, reason: str) -> None:
    channel = driver.Channel(io.StringIO(), io.StringIO())
    with pytest.raises(driver.DriverError, match=reason), driver.connected(address, 1, channel):
        pass
