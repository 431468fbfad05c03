"""What went wrong in user code, and where: the content of the protocol's FAILED frame."""

from __future__ import annotations

import linecache
import sys
import traceback
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import Any

from eventchain_ros2.definitions import MessageDefinitionError
from eventchain_ros2.messages import MalformedMessageError


class HostError(Exception):
    """A failure with an identifier of its own, and the place in a file if there is one (1-based; 0 unknown)."""

    def __init__(self, identifier: str, message: str, file: str = "", line: int = 0, column: int = 0) -> None:
        super().__init__(message)
        self.identifier = identifier
        self.file = file
        self.line = line
        self.column = column


class StepTimeout(BaseException):
    """User code takes too long. Not an `Exception`, so that code which catches those does not catch this."""


def describe(error: BaseException, node: str, folders: Iterable[str]) -> dict[str, Any]:
    """Describe an error as JSON object.

    Args:
        error: what was raised.
        node: the node whose code ran, or "".
        folders: folders of user code; the innermost frame of a file in one of them is the place of the error.

    """
    if isinstance(error, HostError):
        identifier, message, file, line, column = error.identifier, str(error), error.file, error.line, error.column
    elif isinstance(error, MessageDefinitionError):
        identifier, message, file, line, column = "message.definition", str(error), error.file, error.line, 0
    elif isinstance(error, MalformedMessageError):
        identifier, message, file, line, column = "message.malformed", str(error), "", 0, 0
    else:
        message = f"{type(error).__name__}: {error}".removesuffix(": ")
        file, line, column = _place(error, [str(Path(folder).resolve()) for folder in folders])
        owner = "component" if Path(file).parent.name == "components" else "node"
        if isinstance(error, SyntaxError):
            identifier, message = f"{owner}.syntax", f"{type(error).__name__}: {error.msg}"
        elif isinstance(error, StepTimeout):
            identifier, message = f"{owner}.timeout", str(error)
        else:
            identifier = "component.raised" if owner == "component" else "node.failed"
    linecache.checkcache(file)
    return {
        "id": identifier,
        "message": message,
        "node": node,
        "file": file,
        "line": line,
        "column": column,
        "excerpt": linecache.getline(file, line).rstrip("\n") if line else "",
        "traceback": "".join(traceback.format_exception(type(error), error, error.__traceback__)),
    }


def _place(error: BaseException, folders: list[str]) -> tuple[str, int, int]:
    if isinstance(error, SyntaxError) and error.filename:
        return error.filename, error.lineno or 0, error.offset or 0
    place = "", 0, 0
    frame = error.__traceback__
    while frame is not None:
        file = frame.tb_frame.f_code.co_filename
        if any(file.startswith(folder + "/") for folder in folders):
            place = file, frame.tb_lineno, _column(frame)
        frame = frame.tb_next
    return place


def _column(frame: TracebackType) -> int:
    """The column of what the frame executes, where this Python records it (3.11 and later)."""
    if sys.version_info < (3, 11):
        return 0
    positions = list(frame.tb_frame.f_code.co_positions())
    column = positions[frame.tb_lasti // 2][2]
    return 0 if column is None else column + 1
