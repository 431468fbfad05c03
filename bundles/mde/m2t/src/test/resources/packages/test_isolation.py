"""Isolation of the generated tests of a package."""

import os

import rclpy


def test_isolation(monkeypatch, request):
    """The tests run in their own domain, on this machine only."""
    given = []
    init = rclpy.init
    monkeypatch.setattr(rclpy, "init", lambda **options: given.append(options) or init(**options))
    request.getfixturevalue("world")
    assert given == [{"domain_id": 1 + os.getpid() % 101}]
    assert os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"
    assert os.environ["ROS_LOCALHOST_ONLY"] == "1"
