"""Archives of what a node needs: the same bytes for the same files, wherever they are."""

from __future__ import annotations

import hashlib
import io
import os
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

NEVER = {"__pycache__", ".git"}
EARLIEST = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class Pack:
    """An archive, and a name that says what is in it."""

    name: str
    content: bytes


def pack(files: dict[str, Path]) -> Pack:
    """Return an archive of files by their names in it."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, file in sorted(files.items()):
            kind = zipfile.ZIP_STORED if file.suffix == ".jar" else zipfile.ZIP_DEFLATED
            archive.writestr(zipfile.ZipInfo(name, EARLIEST), file.read_bytes(), kind, 1)
    content = buffer.getvalue()
    return Pack(hashlib.sha256(content).hexdigest()[:24], content)


def program(class_path: list[Path]) -> dict[str, Path]:
    """Return the files of a class path, each entry in a folder of its own, since two may have the same name."""
    files: dict[str, Path] = {}
    for number, entry in enumerate(class_path):
        place = entry_name(number, entry)
        if entry.is_dir():
            files.update({f"{place}/{file.relative_to(entry)}": file for file in below(entry)})
        elif entry.is_file():
            files[place] = entry
    return files


def entry_name(number: int, entry: Path) -> str:
    """Return the place of an entry of the class path; its own name is a part of what identifies the program."""
    return f"{number:03}/{entry.name}"


@dataclass(frozen=True)
class Folder:
    """A folder with all that is in it, except for what is left out."""

    path: Path
    without: frozenset[Path] = frozenset()
    hidden: bool = True  # whether names that begin with a dot are sent, too


def project(files: list[Path], folders: list[Folder]) -> dict[str, Path]:
    """Return files by their absolute paths, so that they refer to each other as before."""
    found = {place(file): file for file in files}
    for folder in folders:
        found.update({place(file): file for file in below(folder.path, folder.without, folder.hidden)})
    return found


def place(file: Path) -> str:
    """Return the name of a file in the archive: its absolute path."""
    return str(file).lstrip("/")


def below(
    folder: Path, without: frozenset[Path] = frozenset(), hidden: bool = True, above: frozenset[str] = frozenset()
) -> Iterator[Path]:
    """Return the files of a folder and of those in it; links are followed, except for those that lead in a circle."""
    real = os.path.realpath(folder)
    if real in above:
        return
    for entry in sorted(folder.iterdir()):
        if entry.name in NEVER or entry in without or (entry.name.startswith(".") and not hidden):
            continue
        if entry.is_dir():
            yield from below(entry, without, hidden, above | {real})
        elif entry.is_file():
            yield entry
