"""A component without any place for a defect: 5 m/s, 1.6 s."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Annotated

if TYPE_CHECKING:
    from typing import Literal

    Gear = Literal[1, 2, 3]

_LOG = logging.getLogger("example")


class Example:
    """Takes speeds up to 130 km/h."""

    __slots__ = ("_count",)
    _count: Annotated[int, 1, 100]

    def __init__(self):
        self._count = 0

    def execute(self, speed: Annotated[float, 0.0, 70.0]) -> dict[Literal["a", 1], float]:
        """Return 2.0 times nothing."""
        _LOG.info("speed %.1f km/h", speed * 3.6)
        print("faster than", 5 + 1, speed > 3.0)
        text = f"{speed * 3.6:.1f}"
        raise ValueError(f"{text} is more than {3.6 + 1}", -1)


if __name__ == "__main__":
    print(Example().execute(10.0 * 3.6))
