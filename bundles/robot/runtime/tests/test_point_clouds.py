"""Point clouds: `sensor_msgs_py.point_cloud2`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from sensor_msgs_py import point_cloud2

POINTS = [(1.0, 2.0, 3.0), (float("nan"), 5.0, 6.0), (7.0, 8.0, 9.0)]


@pytest.fixture
def cloud(messages: Messages) -> Any:
    from std_msgs.msg import Header

    cloud = point_cloud2.create_cloud_xyz32(Header(frame_id="lidar"), POINTS)
    return from_cdr(type(cloud), to_cdr(cloud))


def test_points_are_read_as_they_were_written(cloud: Any) -> None:
    assert (cloud.header.frame_id, cloud.width, cloud.height, cloud.point_step, cloud.row_step) == (
        "lidar",
        3,
        1,
        12,
        36,
    )
    points = point_cloud2.read_points(cloud, skip_nans=True)
    assert points["z"].tolist() == [3.0, 9.0]
    assert point_cloud2.read_points_numpy(cloud, ["y", "z"]).tolist() == [[2.0, 3.0], [5.0, 6.0], [8.0, 9.0]]
    (point,) = point_cloud2.read_points_list(cloud, ("x", "z"), uvs=[2])
    assert (point.x, point.z) == (7.0, 9.0)
    with pytest.raises(AssertionError, match=r"not in the fields of the cloud: .*intensity"):
        point_cloud2.read_points(cloud, ["intensity"])


def test_fields_of_different_types_and_rows(messages: Messages) -> None:
    from sensor_msgs.msg import PointField
    from std_msgs.msg import Header

    fields = [
        PointField(name="x", offset=0, datatype=PointField.FLOAT32, count=1),
        PointField(name="ring", offset=6, datatype=PointField.UINT16, count=2),
    ]
    kind = point_cloud2.dtype_from_fields(fields, 16)
    assert (kind.names, kind.itemsize) == (("x", "ring_0", "ring_1"), 16)
    points = np.zeros((2, 3), kind)
    points["ring_1"] = [[1, 2, 3], [4, 5, 6]]
    cloud = point_cloud2.create_cloud(Header(), fields, points, step=16)
    assert (cloud.height, cloud.width, cloud.row_step) == (2, 3, 48)
    assert point_cloud2.read_points(cloud, reshape_organized_cloud=True)["ring_1"].tolist() == [[1, 2, 3], [4, 5, 6]]
    with pytest.raises(AssertionError, match="same datatype"):
        point_cloud2.read_points_numpy(cloud)
    with pytest.raises(AssertionError, match="do not match"):
        point_cloud2.create_cloud(Header(), fields, points)


def test_rows_with_a_gap_and_big_endian_values_are_read(cloud: Any) -> None:
    data = bytes(cloud.data)
    cloud.height, cloud.width, cloud.row_step = 3, 1, 16
    cloud.data = b"".join(data[start : start + 12] + b"gap!" for start in (0, 12, 24))
    assert point_cloud2.read_points(cloud)["y"].tolist() == [2.0, 5.0, 8.0]
    cloud.height, cloud.width, cloud.row_step, cloud.is_bigendian = 1, 3, 36, True
    cloud.data = np.frombuffer(data, "<f4").astype(">f4").tobytes()
    assert point_cloud2.read_points(cloud)["y"].tolist() == [2.0, 5.0, 8.0]
