"""As `cyclonedds.topic`."""

from eventchain_ros2.dds import Topic

__all__ = ["Topic"]
