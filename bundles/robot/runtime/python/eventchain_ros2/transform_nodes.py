"""The parts of `tf2_ros` that belong to nodes: buffer, listener and broadcasters."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from eventchain_ros2 import context
from eventchain_ros2.clock import Duration, Time
from eventchain_ros2.node import Node
from eventchain_ros2.qos import DurabilityPolicy, QoSProfile
from eventchain_ros2.tasks import Future
from eventchain_ros2.transforms import CACHE_TIME, Frames, Transform, TransformException

_NO_TIME = Duration()
_LISTENS = QoSProfile(depth=100)
_LISTENS_STATIC = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_TELLS_STATIC = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class TypeException(Exception):  # noqa: N818 - tf2's name
    """A message of this type cannot be transformed: the module that can, such as tf2_geometry_msgs, is not imported."""


_transforming: dict[type, Callable[[Any, Any], Any]] = {}


class TransformRegistration:
    """The functions that transform messages, by their types."""

    def add(self, message_type: type, function: Callable[[Any, Any], Any]) -> None:
        """Transform messages of a type with a function of a message and a geometry_msgs/msg/TransformStamped."""
        _transforming[message_type] = function

    def get(self, message_type: type) -> Callable[[Any, Any], Any]:
        """Return the function for messages of a type."""
        if message_type not in _transforming:
            raise TypeException(f"Type {message_type} is not loaded or supported: import tf2_geometry_msgs")
        return _transforming[message_type]


class Buffer:
    """Transforms over time. In simulated time nothing arrives while a callback waits, so that it does not wait.

    Args:
        cache_time: how long transforms are kept, 10 s by default.
        node: unused; rclpy's buffer offers a service of frames there.

    """

    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        self._frames = Frames(CACHE_TIME if cache_time is None else cache_time.nanoseconds)
        self._waiting: list[tuple[Callable[[], bool], Future]] = []
        self._frames.changed.append(self._look)

    def set_transform(self, transform: Any, authority: str) -> bool:
        """Note a geometry_msgs/msg/TransformStamped."""
        return self._add(transform, static=False)

    def set_transform_static(self, transform: Any, authority: str) -> bool:
        """Note a geometry_msgs/msg/TransformStamped that always holds."""
        return self._add(transform, static=True)

    def _add(self, message: Any, *, static: bool) -> bool:
        shift, turn = message.transform.translation, message.transform.rotation
        transform = Transform((shift.x, shift.y, shift.z), (turn.x, turn.y, turn.z, turn.w))
        header = message.header
        time = Time.from_msg(header.stamp).nanoseconds
        return self._frames.add(header.frame_id, message.child_frame_id, time, transform, static=static)

    def clear(self) -> None:
        """Forget all transforms."""
        self._frames.clear()

    def lookup_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = _NO_TIME) -> Any:
        """Return the geometry_msgs/msg/TransformStamped that takes coordinates in the source to the target.

        Raises:
            TransformException: there is none within the timeout; its class says why.

        """
        self.can_transform(target_frame, source_frame, time, timeout)
        transform, found = self._frames.lookup(target_frame, source_frame, _nanoseconds(time))
        return _message(target_frame, source_frame, transform, found)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = _NO_TIME,
    ) -> Any:
        """As `lookup_transform`, between two times, through a frame that does not move."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        up, _ = self._frames.lookup(fixed_frame, source_frame, _nanoseconds(source_time))
        down, found = self._frames.lookup(target_frame, fixed_frame, _nanoseconds(target_time))
        return _message(target_frame, source_frame, up.then(down), found)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = _NO_TIME,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Return whether there is a transform within the timeout, and on request why there is none."""
        wanted = target_frame, source_frame, _nanoseconds(time)
        return self._reason(lambda: self._frames.lookup(*wanted), timeout, return_debug_tuple)

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = _NO_TIME,
        return_debug_tuple: bool = False,
    ) -> Any:
        """As `can_transform`, between two times, through a frame that does not move."""

        def both() -> None:
            self._frames.lookup(fixed_frame, source_frame, _nanoseconds(source_time))
            self._frames.lookup(target_frame, fixed_frame, _nanoseconds(target_time))

        return self._reason(both, timeout, return_debug_tuple)

    def _reason(self, look: Callable[[], object], timeout: Duration, with_reason: bool) -> Any:
        reason = ""

        def is_there() -> bool:
            nonlocal reason
            try:
                look()
            except TransformException as problem:
                reason = str(problem)
                return False
            reason = ""
            return True

        found = is_there()
        if not found and timeout != _NO_TIME and context.ok():
            simulation = context.current()
            if not (simulation.is_simulated and simulation.is_within):
                found = simulation.wait_until(is_there, timeout.nanoseconds / 1e9)
        return (found, reason) if with_reason else found

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """Return a future that is done when there is a transform."""
        future = Future()
        self._waiting.append((lambda: self.can_transform(target_frame, source_frame, time), future))
        self._look()
        return future

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Any:
        """Wait for a transform, and return it."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform(target_frame, source_frame, time)

    def _look(self) -> None:
        done = [each for each in self._waiting if each[0]()]
        self._waiting = [each for each in self._waiting if each not in done]
        for _, future in done:
            future.set_result(True)

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Duration = _NO_TIME, new_type: type | None = None
    ) -> Any:
        """Return a message with a header in another frame.

        Raises:
            TransformException: there is no transform.
            TypeException: messages of this type cannot be transformed.

        """
        if new_type is not None:
            raise NotImplementedError("conversions between types are not part of Eventchain's runtime")
        function = TransformRegistration().get(type(object_stamped))
        header = object_stamped.header
        return function(
            object_stamped,
            self.lookup_transform(target_frame, header.frame_id, Time.from_msg(header.stamp), timeout),
        )

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Return the latest time that all frames on the way have."""
        return Time(nanoseconds=self._frames.lookup(target_frame, source_frame)[1])

    def all_frames_as_string(self) -> str:
        """Return a line for each frame with its parent."""
        return "".join(f"Frame {name} exists with parent {parent}.\n" for name, parent, _ in self._frames.parents())

    def all_frames_as_yaml(self) -> str:
        """Return each frame with its parent, as YAML."""
        return "".join(f"{name}:\n  parent: '{parent}'\n" for name, parent, _ in self._frames.parents())


def _nanoseconds(time: Any) -> int:
    return int(time.nanoseconds)


def _message(target: str, source: str, transform: Transform, time: int) -> Any:
    from geometry_msgs.msg import TransformStamped  # type: ignore[import-not-found]

    message = TransformStamped(child_frame_id=source)
    message.header.frame_id, message.header.stamp = target, Time(nanoseconds=time).to_msg()
    shift, turn = message.transform.translation, message.transform.rotation
    shift.x, shift.y, shift.z = transform.translation
    turn.x, turn.y, turn.z, turn.w = transform.rotation
    return message


class TransformListener:
    """Fills a buffer with the transforms on `/tf` and `/tf_static`, in callbacks of a node.

    In real time, `spin_thread` lets a thread run the callbacks of the node.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int = _LISTENS,
        static_qos: QoSProfile | int = _LISTENS_STATIC,
        tf_topic: str = "/tf",
        tf_static_topic: str = "/tf_static",
    ) -> None:
        from tf2_msgs.msg import TFMessage  # type: ignore[import-not-found]

        self.buffer = buffer
        self.node = node
        self.tf_sub = node.create_subscription(TFMessage, tf_topic, self.callback, qos)
        self.tf_static_sub = node.create_subscription(TFMessage, tf_static_topic, self.static_callback, static_qos)
        if spin_thread and not context.is_simulated():
            self._spin()

    def _spin(self) -> None:
        import threading

        from eventchain_ros2.executors import SingleThreadedExecutor

        executor = SingleThreadedExecutor()
        executor.add_node(self.node)
        threading.Thread(target=executor.spin, daemon=True).start()

    def callback(self, data: Any) -> None:
        """Note transforms."""
        for transform in data.transforms:
            self.buffer.set_transform(transform, "default_authority")

    def static_callback(self, data: Any) -> None:
        """Note transforms that always hold."""
        for transform in data.transforms:
            self.buffer.set_transform_static(transform, "default_authority")

    def unregister(self) -> None:
        """Stop listening."""
        self.node.destroy_subscription(self.tf_sub)
        self.node.destroy_subscription(self.tf_static_sub)


class TransformBroadcaster:
    """Publishes transforms on `/tf`."""

    def __init__(self, node: Node, qos: QoSProfile | int = _LISTENS) -> None:
        from tf2_msgs.msg import TFMessage

        self.pub_tf = node.create_publisher(TFMessage, "/tf", qos)

    def sendTransform(self, transform: Any) -> None:  # noqa: N802 - tf2's name
        """Publish a geometry_msgs/msg/TransformStamped, or several."""
        self.pub_tf.publish(self.pub_tf.msg_type(transforms=_list(transform)))


class StaticTransformBroadcaster:
    """Publishes transforms that always hold on `/tf_static`: all that it was given, each time."""

    def __init__(self, node: Node, qos: QoSProfile | int = _TELLS_STATIC) -> None:
        from tf2_msgs.msg import TFMessage

        self.pub_tf = node.create_publisher(TFMessage, "/tf_static", qos)
        self._all: dict[str, Any] = {}

    def sendTransform(self, transform: Any) -> None:  # noqa: N802 - tf2's name
        """Publish a geometry_msgs/msg/TransformStamped, or several."""
        self._all.update((each.child_frame_id, each) for each in _list(transform))
        self.pub_tf.publish(self.pub_tf.msg_type(transforms=list(self._all.values())))


def _list(transform: Any) -> list[Any]:
    return list(transform) if isinstance(transform, list | tuple) else [transform]
