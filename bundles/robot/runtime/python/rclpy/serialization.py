"""As `rclpy.serialization`."""

from __future__ import annotations

from typing import Any

from eventchain_ros2 import refusals
from eventchain_ros2.messages import Message, from_cdr, to_cdr


def serialize_message(message: Message) -> bytes:
    """Return the CDR bytes of a message."""
    return bytes(to_cdr(message))


def deserialize_message(serialized_message: bytes, message_type: type) -> Any:
    """Return the message of CDR bytes."""
    return from_cdr(message_type, serialized_message)


__all__ = ["deserialize_message", "serialize_message"]
__getattr__ = refusals.of_module(__name__)
