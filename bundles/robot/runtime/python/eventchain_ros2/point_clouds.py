"""The points of sensor_msgs/msg/PointCloud2 as NumPy arrays, as in `sensor_msgs_py.point_cloud2`."""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}
"""NumPy types by `datatype` of sensor_msgs/msg/PointField."""
_FLOAT32 = 7


def dtype_from_fields(fields: Iterable[Any], point_step: int | None = None) -> np.dtype[Any]:
    """Return the type of a point: a field of more than one value becomes `NAME_0`, `NAME_1` and so on."""
    names: list[str] = []
    formats: list[Any] = []
    offsets: list[int] = []
    for index, field in enumerate(fields):
        kind = np.dtype(_TYPES[field.datatype])
        name = field.name or f"unnamed_field_{index}"
        for number in range(field.count):
            names.append(f"{name}_{number}" if field.count > 1 else name)
            formats.append(kind)
            offsets.append(field.offset + number * kind.itemsize)
    described: dict[str, Any] = {"names": names, "formats": formats, "offsets": offsets}
    if point_step is not None:
        described["itemsize"] = point_step
    make: Any = np.dtype
    return make(described)  # type: ignore[no-any-return]


def read_points(
    cloud: Any,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    """Return the points as a structured array, a copy.

    Args:
        cloud: the sensor_msgs/msg/PointCloud2.
        field_names: the wanted fields; all by default.
        skip_nans: whether points with a field that is not a number are left out.
        uvs: indices of the wanted points; all by default.
        reshape_organized_cloud: whether the points of a cloud of several rows are in rows.

    Raises:
        AssertionError: there is no such field.

    """
    kind = dtype_from_fields(cloud.fields, cloud.point_step)
    count = cloud.width * cloud.height
    points: Any = np.frombuffer(bytes(cloud.data), np.uint8)
    if cloud.row_step != cloud.width * cloud.point_step:
        points = points.reshape(cloud.height, cloud.row_step)[:, : cloud.width * cloud.point_step]
    points = np.ascontiguousarray(points).reshape(-1)[: count * cloud.point_step].view(kind)
    if bool(cloud.is_bigendian):
        points = points.view(kind.newbyteorder(">")).astype(kind)
    if field_names is not None:
        missing = [name for name in field_names if name not in (kind.names or ())]
        assert not missing, f"Requested field is not in the fields of the cloud: {missing}"
        points = points[list(field_names)]
    points = points.copy()
    if skip_nans and not cloud.is_dense:
        good = np.ones(len(points), bool)
        for name in points.dtype.names:
            good &= ~np.isnan(points[name])
        points = points[good]
    if uvs is not None:
        points = points[np.fromiter(uvs, int)]
    return points.reshape(cloud.height, cloud.width) if reshape_organized_cloud and cloud.height > 1 else points


def read_points_numpy(
    cloud: Any,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    """Return the points as an array with a column for each field, which all have the same type."""
    points = read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud)
    kinds = {points.dtype[name] for name in points.dtype.names}
    assert len(kinds) == 1, "All fields need to have the same datatype. Use `read_points()` otherwise."
    return np.stack([points[name] for name in points.dtype.names], axis=-1)


def read_points_list(
    cloud: Any,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
) -> list[Any]:
    """Return the points as a list of named tuples."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    make: Any = namedtuple
    point = make("Point", points.dtype.names)
    return [point._make(each) for each in points.tolist()]


def create_cloud(header: Any, fields: Sequence[Any], points: Any, step: int | None = None) -> Any:
    """Return a sensor_msgs/msg/PointCloud2.

    Args:
        header: its std_msgs/msg/Header.
        fields: its sensor_msgs/msg/PointField list.
        points: a structured array, or points with a value for each field; two dimensions make rows.
        step: length of a point in bytes; that of the fields by default.

    """
    from sensor_msgs.msg import PointCloud2  # type: ignore[import-not-found]

    kind = dtype_from_fields(fields, step)
    array: Any = np.asarray(points)
    if array.dtype.names is None:
        values = array if array.ndim > 1 else array.reshape(-1, len(kind.names or ()))
        array = np.zeros(values.shape[:-1], kind)
        for index, name in enumerate(kind.names or ()):
            array[name] = values[..., index]
    assert array.dtype == kind, "PointFields and structured NumPy array dtype do not match for all fields!"
    rows = array.shape if array.ndim == 2 else (1, array.shape[0])
    return PointCloud2(
        header=header,
        height=rows[0],
        width=rows[1],
        is_dense=False,
        is_bigendian=False,
        fields=list(fields),
        point_step=kind.itemsize,
        row_step=kind.itemsize * rows[1],
        data=np.ascontiguousarray(array).tobytes(),
    )


def create_cloud_xyz32(header: Any, points: Any) -> Any:
    """Return a sensor_msgs/msg/PointCloud2 of points with x, y and z."""
    from sensor_msgs.msg import PointField

    fields = [
        PointField(name=name, offset=4 * index, datatype=_FLOAT32, count=1)
        for index, name in enumerate(("x", "y", "z"))
    ]
    return create_cloud(header, fields, points)
