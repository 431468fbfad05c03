"""As `cyclonedds.pub`."""

from eventchain_ros2.dds import DataWriter

__all__ = ["DataWriter"]
