"""Errors in user code and their places: the content of the protocol's FAILED frame."""

from __future__ import annotations

import linecache
import traceback
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from component_client import ComponentError
from component_process import place_of

from eventchain_ros2 import refusals
from eventchain_ros2.definitions import MessageDefinitionError
from eventchain_ros2.messages import MalformedMessageError
from eventchain_ros2.processes import LateEndpointError
from eventchain_ros2.simulation import LimitError


class HostError(Exception):
    """A failure with its own identifier, and the place in a file if there is one (1-based; 0 unknown)."""

    def __init__(self, identifier: str, message: str, file: str = "", line: int = 0, column: int = 0) -> None:
        super().__init__(message)
        self.identifier = identifier
        self.file = file
        self.line = line
        self.column = column


class StepTimeout(BaseException):
    """A node takes too long. Not an `Exception`, so that user code does not catch it."""


def describe(error: BaseException, node: str, folders: Iterable[str]) -> dict[str, Any]:
    """Describe an error as JSON object.

    Args:
        error: the raised error.
        node: the node whose code ran, or "".
        folders: folders of user code; the innermost frame of a file in one of them is the place of the error.

    """
    identifier, message, file, line, column = _what_and_where(error, folders)
    linecache.checkcache(file)
    return {
        "id": identifier,
        "message": message,
        "hint": getattr(error, "hint", "") or refusals.hint(error),
        "node": node,
        "file": file,
        "line": line,
        "column": column,
        "excerpt": linecache.getline(file, line).rstrip("\n") if line else "",
        "traceback": "".join(traceback.format_exception(type(error), error, error.__traceback__)),
    }


def _what_and_where(error: BaseException, folders: Iterable[str]) -> tuple[str, str, str, int, int]:
    if isinstance(error, HostError | ComponentError):
        return error.identifier, str(error), error.file, error.line, error.column
    if isinstance(error, LimitError):
        return "simulation.limit", str(error), "", 0, 0
    if isinstance(error, MessageDefinitionError):
        return "message.definition", str(error), error.file, 0, 0
    if isinstance(error, MalformedMessageError):
        return "message.malformed", str(error), "", 0, 0
    if isinstance(error, SyntaxError):
        place = error.filename or "", error.lineno or 0, error.offset or 0
        return "node.syntax", f"{type(error).__name__}: {error.msg}", *place
    place = place_of(error, [str(Path(folder).resolve()) for folder in folders])
    if isinstance(error, LateEndpointError):
        return "node.endpoint.late", str(error), *place
    if isinstance(error, StepTimeout):
        return "node.timeout", str(error), *place
    return "node.failed", f"{type(error).__name__}: {error}".removesuffix(": "), *place
