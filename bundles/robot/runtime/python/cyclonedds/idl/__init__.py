"""As `cyclonedds.idl`."""

from eventchain_ros2.idl import IdlStruct

__all__ = ["IdlStruct"]
