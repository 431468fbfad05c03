"""As `cyclonedds.util`."""

from eventchain_ros2.dds import INFINITY


def duration(
    *,
    seconds: float = 0,
    milliseconds: float = 0,
    microseconds: float = 0,
    nanoseconds: int = 0,
    infinite: bool = False,
) -> int:
    """Return a duration in nanoseconds."""
    return INFINITY if infinite else int(((seconds * 1000 + milliseconds) * 1000 + microseconds) * 1000 + nanoseconds)
