"""As `cyclonedds.sub`."""

from eventchain_ros2.dds import DataReader

__all__ = ["DataReader"]
