"""As `cyclonedds.idl.annotations`."""

from typing import TypeVar

_Class = TypeVar("_Class", bound=type)


def final(cls: _Class) -> _Class:
    """Mark a type as not extensible. Here every type is final."""
    return cls
