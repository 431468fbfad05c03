"""As `cyclonedds.domain`."""

from eventchain_ros2.dds import DomainParticipant

__all__ = ["DomainParticipant"]
