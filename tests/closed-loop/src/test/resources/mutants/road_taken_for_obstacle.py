"""Wrong on purpose: it does not leave out the road."""

import array
import math

import numpy as np

LIDAR_BEHIND_BUMPER = 2.4
"""m from the front bumper back to the lidar."""
LIDAR_ABOVE_ROAD = 2.4
"""m from the road up to the lidar."""
CORRIDOR_HALF_WIDTH = 1.2
"""m left and right of the vehicle's centre line."""
LOWEST_OBSTACLE = -0.3
"""m above the road; what lies lower is the road or can be driven over."""
HIGHEST_OBSTACLE = 2.5
"""m above the road; what hangs higher can be driven under."""
RANGE_MIN = 0.0
"""m, shortest valid range."""
RANGE_MAX = 100.0
"""m, longest valid range."""
BEAMS = 181
"""One beam of one degree from -90 to +90 degrees."""
NOMINAL_SCAN_TIME = 0.05
"""s between two scans, until two scans have been seen."""


class ObjectDetection:
    """Finds the nearest obstacle in each direction of the driving corridor."""

    def __init__(self):
        """Start without a previous scan."""
        self._last_stamp = None
        self._scan_time = NOMINAL_SCAN_TIME

    def execute(self, stamp_sec, stamp_nanosec, height, width, point_step, row_step, data):
        """Take the fields of a PointCloud2 whose points start with x, y, z as little-endian float32.

        The points are in metres in the lidar's frame (x forward, y left, z up). Returns the fields of a
        LaserScan in the front bumper's frame; a beam without an obstacle is infinite (REP 117).
        """
        self._measure_scan_time(stamp_sec, stamp_nanosec)
        points = np.ndarray(
            (height, width, 3), dtype="<f4", buffer=data, strides=(row_step, point_step, 4)
        ).reshape(-1, 3)
        return {
            "scan_stamp_sec": stamp_sec,
            "scan_stamp_nanosec": stamp_nanosec,
            "frame_id": "ego_vehicle/front_bumper",
            "angle_min": -math.pi / 2,
            "angle_max": math.pi / 2,
            "angle_increment": math.pi / (BEAMS - 1),
            "scan_time": self._scan_time,
            "range_min": RANGE_MIN,
            "range_max": RANGE_MAX,
            "ranges": array.array("f", self._ranges(points).tobytes()),
        }

    def _measure_scan_time(self, stamp_sec, stamp_nanosec):
        stamp = stamp_sec * 1_000_000_000 + stamp_nanosec
        if self._last_stamp is not None and stamp > self._last_stamp:
            self._scan_time = (stamp - self._last_stamp) / 1e9
        self._last_stamp = stamp

    def _ranges(self, points):
        in_corridor = points[np.abs(points[:, 1]) <= CORRIDOR_HALF_WIDTH]
        ahead = in_corridor[:, 0] >= LIDAR_BEHIND_BUMPER
        above_road = in_corridor[:, 2] >= LOWEST_OBSTACLE - LIDAR_ABOVE_ROAD
        below_roof = in_corridor[:, 2] <= HIGHEST_OBSTACLE - LIDAR_ABOVE_ROAD
        obstacles = in_corridor[ahead & above_road & below_roof].astype(np.float64)
        forward = obstacles[:, 0] - LIDAR_BEHIND_BUMPER
        left = obstacles[:, 1]
        distances = np.hypot(forward, left)
        beams = np.rint(np.degrees(np.arctan2(left, forward))).astype(np.intp) + BEAMS // 2
        ranges = np.full(BEAMS, np.inf, dtype=np.float32)
        valid = distances <= RANGE_MAX
        np.minimum.at(ranges, beams[valid], distances[valid].astype(np.float32))
        return ranges
