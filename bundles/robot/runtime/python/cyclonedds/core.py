"""As `cyclonedds.core`."""

from eventchain_ros2.dds import Policy, Qos

__all__ = ["Policy", "Qos"]
