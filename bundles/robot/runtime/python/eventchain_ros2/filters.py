"""Messages that belong together, as in `message_filters`: by equal stamps, or by similar ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

from eventchain_ros2.clock import Clock, ClockType, Duration, Time
from eventchain_ros2.context import current, ok
from eventchain_ros2.node import Node
from eventchain_ros2.processes import Sample


class SimpleFilter:
    """A source of messages for callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., object], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., object], *args: Any) -> int:  # noqa: N802 - the name in ROS
        """Call this with each message, and the arguments; return the number of the connection."""
        connection = len(self.callbacks)
        self.callbacks[connection] = cb, args
        return connection

    def signalMessage(self, *msg: Any) -> None:  # noqa: N802 - the name in ROS
        """Give messages to all callbacks."""
        for callback, arguments in list(self.callbacks.values()):
            callback(*msg, *arguments)


class Subscriber(SimpleFilter):
    """A subscription as a source.

    Args:
        node: the node that subscribes.
        msg_type: type of the messages.
        topic: their topic.
        options: of `create_subscription`; `qos_profile` is 10 by default.

    """

    def __init__(self, node: Node, msg_type: type, topic: str, **options: Any) -> None:
        super().__init__()
        self.node = node
        self.topic = topic
        options.setdefault("qos_profile", 10)
        self.sub = node.create_subscription(msg_type, topic, self.callback, **options)

    def callback(self, msg: Any) -> None:
        """Pass a message on."""
        self.signalMessage(msg)

    def getTopic(self) -> str:  # noqa: N802 - the name in ROS
        """Return the topic."""
        return self.topic


def _stamp(message: Any, *, headerless: bool) -> int:
    """Return the time of a message in ns: its stamp, or that of its arrival.

    Raises:
        TypeError: it has no header, and the arrival does not count.

    """
    header = getattr(message, "header", None)
    if header is not None and hasattr(header, "stamp"):
        return Time.from_msg(header.stamp).nanoseconds
    if not headerless:
        text = "has no header with a stamp: pass allow_headerless=True, so that its arrival counts"
        raise TypeError(f"a message of {type(message).__name__} {text}")
    return Clock(clock_type=ClockType.ROS_TIME).now().nanoseconds


class Cache(SimpleFilter):
    """The last messages of a source, by their stamps.

    Args:
        f: the source, or None.
        cache_size: number of messages that are kept.
        allow_headerless: whether the arrival counts for messages without a header.

    """

    def __init__(self, f: SimpleFilter | None, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self._size = cache_size
        self._headerless = allow_headerless
        self._kept: list[tuple[int, Any]] = []
        if f is not None:
            f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message, and pass it on."""
        self._kept.append((_stamp(msg, headerless=self._headerless), msg))
        self._kept.sort(key=lambda kept: kept[0])
        del self._kept[: -self._size]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:  # noqa: N802 - the name in ROS
        """Return the messages between two times, inclusive."""
        return [msg for time, msg in self._kept if from_stamp.nanoseconds <= time <= to_stamp.nanoseconds]

    def getElemAfterTime(self, stamp: Time) -> Any:  # noqa: N802 - the name in ROS
        """Return the first message that is not before a time, or None."""
        return next((msg for time, msg in self._kept if time >= stamp.nanoseconds), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:  # noqa: N802 - the name in ROS
        """Return the last message that is not after a time, or None."""
        return next((msg for time, msg in reversed(self._kept) if time <= stamp.nanoseconds), None)

    def getLatestTime(self) -> Time | None:  # noqa: N802 - the name in ROS
        """Return the time of the last message, or None."""
        return self._time(-1)

    getLastestTime = getLatestTime  # noqa: N815 - the name in ROS

    def getOldestTime(self) -> Time | None:  # noqa: N802 - the name in ROS
        """Return the time of the first message, or None."""
        return self._time(0)

    def _time(self, index: int) -> Time | None:
        return Time(nanoseconds=self._kept[index][0], clock_type=ClockType.ROS_TIME) if self._kept else None

    def getLast(self) -> Any:  # noqa: N802 - the name in ROS
        """Return the last message, or None."""
        return self._kept[-1][1] if self._kept else None


def _held() -> Sample | None:
    """Return the sample that the running callback is given: it counts as read once its message is given on."""
    process = current().current if ok() else None
    return None if process is None else process.hold()


class TimeSynchronizer(SimpleFilter):
    """Gives messages of several sources together that have the same stamp.

    Args:
        fs: the sources.
        queue_size: number of messages of a source that are kept.

    """

    _headerless = False

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.queues: list[dict[int, tuple[Any, Sample | None]]] = [{} for _ in fs]
        for index, source in enumerate(fs):
            source.registerCallback(self.add, index)

    def add(self, msg: Any, index: int) -> None:
        """Note a message of a source; give those that belong to it, if they are complete."""
        time = _stamp(msg, headerless=self._headerless)
        queue = self.queues[index]
        queue[time] = msg, _held()
        while len(queue) > self.queue_size:
            del queue[min(queue)]
        if time in queue:
            self._match(time, index)

    def _match(self, time: int, index: int) -> None:
        if all(time in queue for queue in self.queues):
            self._give([time] * len(self.queues))

    def _give(self, times: list[int]) -> None:
        given = [queue.pop(time) for queue, time in zip(self.queues, times, strict=True)]
        for _, sample in given:
            if sample is not None and (process := current().current) is not None:
                process.latest[sample.topic] = sample.sequence
        self.signalMessage(*[msg for msg, _ in given])


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Gives messages of several sources together whose stamps differ by less than `slop`, each only once.

    Args:
        fs: the sources.
        queue_size: number of messages of a source that are kept.
        slop: in s.
        allow_headerless: whether the arrival counts for messages without a header.

    """

    def __init__(
        self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self._headerless = allow_headerless

    def _match(self, time: int, index: int) -> None:
        slop = self.slop.nanoseconds
        near = [
            sorted((each for each in queue if abs(each - time) <= slop), key=lambda each: (abs(each - time), each))
            for queue in self.queues
        ]
        near[index] = [time]
        for times in product(*near):
            if max(times) - min(times) < slop:
                self._give(list(times))
                return
