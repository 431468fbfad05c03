"""Messages as arguments and results of components: their encoding and decoding."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

from component_values import Objects

from eventchain_ros2 import catalog
from eventchain_ros2.idl import IdlStruct
from eventchain_ros2.messages import Message, Messages, type_name


def of(messages: Messages, *, importing: bool) -> Objects:
    """Return the message classes of a catalog, and those of modules.

    Args:
        messages: the classes of ROS 2.
        importing: whether modules may be imported for their `IdlStruct` classes; else they have to be loaded.

    """

    def make(name: str, fields: dict[str, Any]) -> Any:
        module, separator, class_name = name.partition(":")
        if not separator:
            return messages.get(name)(**fields)
        if importing:
            importlib.import_module(module)
        message_class = getattr(sys.modules[module], class_name)
        if not (isinstance(message_class, type) and issubclass(message_class, IdlStruct)):
            raise TypeError(f"{name} is not a message")
        return message_class(**fields)

    return Objects(_describe, make)


def serve(files: list[str]) -> Objects:
    """The same in the process of a component, which then can import message packages, too.

    The files, which the process of the nodes has read before, are read when a component needs a message: few do.
    """
    messages = Messages(lambda: catalog.read(map(Path, files)))
    messages.install()
    return of(messages, importing=True)


def _describe(value: Any) -> tuple[str, dict[str, Any]] | None:
    if isinstance(value, Message):
        return type_name(type(value)), {name: getattr(value, name) for name in value.__slots__}
    if isinstance(value, IdlStruct):
        return f"{type(value).__module__}:{type(value).__qualname__}", dict(vars(value))
    return None
