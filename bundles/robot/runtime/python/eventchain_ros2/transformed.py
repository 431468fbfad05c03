"""Messages of geometry_msgs in other frames, as in `tf2_geometry_msgs`."""

from __future__ import annotations

from typing import Any

from eventchain_ros2.transform_nodes import TransformRegistration
from eventchain_ros2.transforms import Transform, Vector, product, rotated


def _transform(message: Any) -> Transform:
    shift, turn = message.transform.translation, message.transform.rotation
    return Transform((shift.x, shift.y, shift.z), (turn.x, turn.y, turn.z, turn.w))


def _set(message: Any, vector: Vector) -> Any:
    message.x, message.y, message.z = vector
    return message


def _vector(message: Any) -> Vector:
    return message.x, message.y, message.z


def do_transform_point(point: Any, transform: Any) -> Any:
    """Return a geometry_msgs/msg/PointStamped in the frame to which a TransformStamped leads."""
    result = type(point)(header=transform.header)
    _set(result.point, _transform(transform).point(_vector(point.point)))
    return result


def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    """Return a geometry_msgs/msg/Vector3Stamped in the frame to which a TransformStamped leads: it is only rotated."""
    result = type(vector3)(header=transform.header)
    _set(result.vector, rotated(_vector(vector3.vector), _transform(transform).rotation))
    return result


def do_transform_pose(pose: Any, transform: Any) -> Any:
    """Return a geometry_msgs/msg/Pose in the frame to which a TransformStamped leads."""
    result, change = type(pose)(), _transform(transform)
    _set(result.position, change.point(_vector(pose.position)))
    turn = pose.orientation
    orientation = product(change.rotation, (turn.x, turn.y, turn.z, turn.w))
    result.orientation.x, result.orientation.y, result.orientation.z, result.orientation.w = orientation
    return result


def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    """Return a geometry_msgs/msg/PoseStamped in the frame to which a TransformStamped leads."""
    return type(pose)(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def register() -> None:
    """Let buffers transform these messages."""
    from geometry_msgs.msg import PointStamped, PoseStamped, Vector3Stamped  # type: ignore[import-not-found]

    registration = TransformRegistration()
    registration.add(PointStamped, do_transform_point)
    registration.add(PoseStamped, do_transform_pose_stamped)
    registration.add(Vector3Stamped, do_transform_vector3)
