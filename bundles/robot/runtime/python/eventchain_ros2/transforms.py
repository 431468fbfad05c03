"""Coordinate frames over time, as the buffer of `tf2` keeps them: a tree of transforms, interpolated in between.

Rotations are unit quaternions `(x, y, z, w)`, times nanoseconds. The transform from a frame to its parent takes
coordinates in the frame to coordinates in the parent.
"""

from __future__ import annotations

import sys
import threading
from bisect import bisect_left
from collections.abc import Callable, Iterator
from math import acos, isfinite, sin, sqrt
from typing import NamedTuple

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

CACHE_TIME = 10_000_000_000
"""Time for which transforms are kept, in ns."""

_NEARLY_PARALLEL = 1 - 1e-9
_LARGEST_NORM_ERROR = 1e-2
_LONGEST_CHAIN = 1000


class TransformException(Exception):  # noqa: N818 - tf2's names
    """There is no transform."""


class LookupException(TransformException):
    """A frame does not exist."""


class ConnectivityException(TransformException):
    """The frames belong to different trees."""


class ExtrapolationException(TransformException):
    """The time is before the first or after the last transform."""


class InvalidArgumentException(TransformException):
    """A frame has no valid name."""


class TimeoutException(TransformException):
    """The time for waiting is over."""


class Transform(NamedTuple):
    """A rotation and then a translation."""

    translation: Vector
    rotation: Quaternion

    def then(self, outer: Transform) -> Transform:
        """Return the transform that does this one first and then the outer one."""
        return Transform(outer.point(self.translation), product(outer.rotation, self.rotation))

    def inverse(self) -> Transform:
        """Return the transform back."""
        x, y, z, w = self.rotation
        back = -x, -y, -z, w
        a, b, c = rotated(self.translation, back)
        return Transform((-a, -b, -c), back)

    def point(self, point: Vector) -> Vector:
        """Return a point in the other frame."""
        x, y, z = rotated(point, self.rotation)
        a, b, c = self.translation
        return x + a, y + b, z + c


IDENTITY = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def product(one: Quaternion, other: Quaternion) -> Quaternion:
    """Return the rotation that does the other one first."""
    a, b, c, d = one
    x, y, z, w = other
    return (
        d * x + a * w + b * z - c * y,
        d * y - a * z + b * w + c * x,
        d * z + a * y - b * x + c * w,
        d * w - a * x - b * y - c * z,
    )


def rotated(vector: Vector, by: Quaternion) -> Vector:
    """Return a rotated vector."""
    x, y, z, w = by
    a, b, c = vector
    # v + 2 w (q x v) + 2 q x (q x v), with q the vector of the quaternion
    d, e, f = 2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)
    return a + w * d + y * f - z * e, b + w * e + z * d - x * f, c + w * f + x * e - y * d


def between(one: Transform, other: Transform, share: float) -> Transform:
    """Return the transform at a share of the way: translations on a line, rotations on the shorter arc."""
    x, y, z = (a + (b - a) * share for a, b in zip(one.translation, other.translation, strict=True))
    cosine = sum(a * b for a, b in zip(one.rotation, other.rotation, strict=True))
    sign = 1 if cosine >= 0 else -1
    if abs(cosine) >= _NEARLY_PARALLEL:
        first, second = 1 - share, share
    else:
        angle = acos(abs(cosine))
        first, second = sin((1 - share) * angle) / sin(angle), sin(share * angle) / sin(angle)
    turned = tuple(a * first + b * second * sign for a, b in zip(one.rotation, other.rotation, strict=True))
    return Transform((x, y, z), _normalized(turned))


def _normalized(rotation: tuple[float, ...]) -> Quaternion:
    length = sqrt(sum(each * each for each in rotation))
    x, y, z, w = (each / length for each in rotation)
    return x, y, z, w


class _Sample(NamedTuple):
    time: int
    parent: str
    transform: Transform


class _Frame:
    """The transforms of a frame to its parent, by time; a static one has only one, which always holds."""

    def __init__(self, *, static: bool) -> None:
        self.static = static
        self.samples: list[_Sample] = []

    def latest(self) -> _Sample:
        return self.samples[-1]

    def at(self, time: int) -> _Sample:
        """Return the transform at a time, 0 for the latest."""
        if self.static or time == 0:
            return self.latest()
        index = bisect_left(self.samples, time, key=lambda sample: sample.time)
        if index < len(self.samples) and self.samples[index].time == time:
            return self.samples[index]
        if index == len(self.samples):
            latest = self.latest().time
            raise ExtrapolationException(_extrapolation("future", time, "latest", latest))
        if index == 0:
            raise ExtrapolationException(_extrapolation("past", time, "earliest", self.samples[0].time))
        before, after = self.samples[index - 1 : index + 1]
        if before.parent != after.parent:
            return before
        share = (time - before.time) / (after.time - before.time)
        return _Sample(time, before.parent, between(before.transform, after.transform, share))


def _extrapolation(where: str, wanted: int, end: str, there: int) -> str:
    times = f"Requested time {_seconds(wanted)} but the {end} data is at time {_seconds(there)}"
    return f"Lookup would require extrapolation into the {where}.  {times}"


def _seconds(time: int) -> str:
    return f"{time // 1_000_000_000}.{time % 1_000_000_000 // 1000:06}"


class Frames:
    """All frames that are known.

    Args:
        cache_time: how long transforms are kept, in ns.

    """

    def __init__(self, cache_time: int = CACHE_TIME) -> None:
        self._cache_time = cache_time
        self._lock = threading.RLock()  # one thread may listen, and another look up
        self._frames: dict[str, _Frame] = {}
        self._parents: set[str] = set()
        self.changed: list[Callable[[], None]] = []
        """Called after each new transform."""

    def clear(self) -> None:
        """Forget all frames."""
        self._frames.clear()
        self._parents.clear()

    def names(self) -> list[str]:
        """Return the names of all frames, sorted."""
        return sorted({*self._frames, *self._parents})

    def parents(self) -> Iterator[tuple[str, str, int]]:
        """Return each frame that has a parent, its last parent and the time of that."""
        for name, frame in sorted(self._frames.items()):
            yield name, frame.latest().parent, frame.latest().time

    def add(self, parent: str, child: str, time: int, transform: Transform, *, static: bool = False) -> bool:
        """Note a transform; return whether it could be used. What cannot is told on standard error, as in tf2."""
        problem = _problem(parent, child, transform)
        if problem:
            print(f"[ERROR] tf2: {problem}, so it is ignored", file=sys.stderr)
            return False
        sample = _Sample(time, parent, transform._replace(rotation=_normalized(transform.rotation)))
        with self._lock:
            frame = self._frames.get(child)
            if frame is None or frame.static != static:
                frame = self._frames[child] = _Frame(static=static)
            is_new = self._keep(frame, sample)
            self._parents.add(parent)
        if not is_new:
            print(f"[WARN] tf2: a transform of '{child}' is repeated or too old, so it is ignored", file=sys.stderr)
            return False
        for callback in list(self.changed):
            callback()
        return True

    def _keep(self, frame: _Frame, sample: _Sample) -> bool:
        if frame.static:
            frame.samples = [sample]
            return True
        index = bisect_left(frame.samples, sample.time, key=lambda each: each.time)
        repeated = index < len(frame.samples) and frame.samples[index].time == sample.time
        if repeated or (frame.samples and sample.time < frame.latest().time - self._cache_time):
            return False
        frame.samples.insert(index, sample)
        oldest = frame.latest().time - self._cache_time
        del frame.samples[: bisect_left(frame.samples, oldest, key=lambda each: each.time)]
        return True

    def lookup(self, target: str, source: str, time: int = 0) -> tuple[Transform, int]:
        """Return the transform that takes coordinates in the source to the target, and its time.

        Args:
            target: name of a frame.
            source: name of a frame.
            time: in ns; 0 for the latest time that all frames on the way have.

        Raises:
            TransformException: there is none; the subclass says why.

        """
        with self._lock:
            return self._lookup(target, source, time)

    def _lookup(self, target: str, source: str, time: int) -> tuple[Transform, int]:
        for role, name in (("target_frame", target), ("source_frame", source)):
            self._require(name, role)
        if time == 0:
            time = self._latest_common_time(target, source)
        (up, up_problem), (down, down_problem) = self._way(source, time), self._way(target, time)
        common = next((name for name in up if name in down), None)
        if common is None:
            problem = up_problem or down_problem
            if problem:
                text = f"{problem}, when looking up transform from frame [{source}] to frame [{target}]"
                raise ExtrapolationException(text)
            raise ConnectivityException(_unconnected(target, source))
        return up[common].then(down[common].inverse()), time

    def _require(self, name: str, role: str) -> None:
        if not name or name.startswith("/"):
            raise InvalidArgumentException(
                f'Invalid argument "{name}" passed to lookupTransform argument {role}: '
                "a frame has a name, which does not start with a '/'"
            )
        if name not in self._frames and name not in self._parents:
            raise LookupException(f'"{name}" passed to lookupTransform argument {role} does not exist.')

    def _way(self, name: str, time: int) -> tuple[dict[str, Transform], ExtrapolationException | None]:
        """Return the transforms of a frame to its ancestors and to itself, and why the way ends before the root."""
        found = {name: IDENTITY}
        here = IDENTITY
        while name in self._frames:
            try:
                sample = self._frames[name].at(time)
            except ExtrapolationException as problem:
                return found, problem
            here, name = here.then(sample.transform), sample.parent
            if name in found or len(found) > _LONGEST_CHAIN:
                raise LookupException("The tf tree is invalid because it contains a loop.")
            found[name] = here
        return found, None

    def _latest_common_time(self, target: str, source: str) -> int:
        (up, _), (down, _) = self._way(source, 0), self._way(target, 0)
        common = next((name for name in up if name in down), None)
        if common is None:
            raise ConnectivityException(_unconnected(target, source))
        times = []
        for way in (up, down):
            for name in way:
                if name == common:
                    break
                if not self._frames[name].static:
                    times.append(self._frames[name].latest().time)
        return min(times, default=0)


def _unconnected(target: str, source: str) -> str:
    return (
        f"Could not find a connection between '{target}' and '{source}' because they are not part of the same tree. "
        "Tf has two or more unconnected trees."
    )


def _problem(parent: str, child: str, transform: Transform) -> str:
    """Return why a transform cannot be used; empty: it can."""
    what = f"the transform of '{child}' to '{parent}'"
    if not parent or not child:
        return f"{what} lacks the name of a frame"
    if parent == child:
        return f"{what} leads to itself"
    if not all(isfinite(each) for each in (*transform.translation, *transform.rotation)):
        return f"{what} is not finite"
    if abs(sum(each * each for each in transform.rotation) - 1) > _LARGEST_NORM_ERROR:
        return f"{what} has a rotation that is no unit quaternion"
    return ""
