"""Catalog of the available message types."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from eventchain_ros2.definitions import Definition, MessageDefinitionError, resolved

REQUEST, RESPONSE = "_Request", "_Response"
"""Ends of the names of the two messages of a service: those of `std_srvs/srv/Empty` begin with its name."""
STANDARD_MESSAGES = Path(__file__).with_name("humble.json")
STANDARD_SERVICES = Path(__file__).with_name("services.json")


class Catalog:
    """The message types that can be used: the standard ones, and others.

    Args:
        own: definitions by full names, as JSON holds them (`definitions.resolved`). They hide standard types.

    """

    def __init__(self, own: Mapping[str, Any] | None = None) -> None:
        self._stated = {**_STANDARD, **(own or {})}
        self._packages = {name.partition("/")[0] for name in self._stated}

    def names(self) -> list[str]:
        """Full names of all types, sorted."""
        return sorted(self._stated)

    def has_package(self, package: str) -> bool:
        """Return whether there are types of a package."""
        return package in self._packages or any(name.startswith(f"{package}/") for name in _services())

    def members(self, package: str) -> list[str]:
        """Names of the message types of a package, without the package, sorted."""
        return self._of(f"{package}/msg/")

    def services(self, package: str) -> list[str]:
        """Names of the service types of a package, without the package, sorted."""
        found = self._of(f"{package}/srv/")
        return [name.removesuffix(REQUEST) for name in found if name.endswith(REQUEST)]

    def _of(self, start: str) -> list[str]:
        names = {*self._stated, *_services()}
        return sorted(name.removeprefix(start) for name in names if name.startswith(start))

    def find(self, name: str) -> Definition | None:
        """Return the definition of the type with this full name.

        Raises:
            MessageDefinitionError: it is not defined as it has to be.

        """
        stated = self._stated[name] if name in self._stated else _services().get(name)
        return None if stated is None else resolved(name, stated)


_STANDARD: dict[str, Any] = json.loads(STANDARD_MESSAGES.read_text(encoding="utf-8"))
"""Read on import: once for all processes that are forked after it."""


@functools.cache
def _services() -> dict[str, Any]:
    """Definitions of packages that `STANDARD_MESSAGES` lacks, services above all: read when something is not in it."""
    services: dict[str, Any] = json.loads(STANDARD_SERVICES.read_text(encoding="utf-8"))
    return services


def read(files: Iterable[Path]) -> dict[str, Any]:
    """The definitions in files that `eventchain messages` has written; an earlier file hides a later one.

    Raises:
        MessageDefinitionError: one of them cannot be read, or is no such file.

    """
    found: dict[str, Any] = {}
    for file in reversed(list(files)):
        found.update(_read(file))
    return found


def _read(file: Path) -> dict[str, Any]:
    if file.is_dir():
        problem = f"{file} is a folder; `eventchain messages {file} > FILE` writes the file that is needed"
        raise MessageDefinitionError(problem, str(file))
    try:
        stated = json.loads(file.read_text(encoding="utf-8"))
        if not isinstance(stated, dict):
            raise ValueError("it is no object")
    except (OSError, ValueError) as problem:
        raise MessageDefinitionError(f"{file} cannot be read: {problem}", str(file)) from None
    return stated
