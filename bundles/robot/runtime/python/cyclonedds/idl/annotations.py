"""As `cyclonedds.idl.annotations`."""

from typing import TypeVar

_Class = TypeVar("_Class", bound=type)


def final(cls: _Class) -> _Class:
    """Mark a type to which nobody adds fields. Here every type is one."""
    return cls
