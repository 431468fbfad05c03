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
            files.update({f"{place}/{file.relative_to(entry)}": file for file in below(entry, set())})
        elif entry.is_file():
            files[place] = entry
    return files


def entry_name(number: int, entry: Path) -> str:
    """Return the place of an entry of the class path; its own name is a part of what identifies the program."""
    return f"{number:03}/{entry.name}"


def project(files: list[Path], folders: dict[Path, set[Path]]) -> dict[str, Path]:
    """Return files by their absolute paths, so that they refer to each other as before.

    ``folders`` has folders with all that is in them, each with the files and folders that are left out.
    """
    found = {place(file): file for file in files}
    for folder, without in folders.items():
        found.update({place(file): file for file in below(folder, without)})
    return found


def place(file: Path) -> str:
    """Return the name of a file in the archive: its absolute path."""
    return str(file).lstrip("/")


def below(folder: Path, without: set[Path], above: frozenset[str] = frozenset()) -> Iterator[Path]:
    """Return the files of a folder and of those in it; links are followed, except for those that lead in a circle."""
    real = os.path.realpath(folder)
    if real in above:
        return
    for entry in sorted(folder.iterdir()):
        if entry.name in NEVER or entry in without:
            continue
        if entry.is_dir():
            yield from below(entry, without, above | {real})
        elif entry.is_file():
            yield entry
