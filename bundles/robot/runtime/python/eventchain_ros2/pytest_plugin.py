"""Pytest plugin that runs the tests of a ROS 2 package on this runtime, in simulated time.

    PYTHONPATH=FOLDER python -m pytest -p eventchain_ros2.pytest_plugin [--messages MESSAGES]... test

FOLDER holds this package, and each MESSAGES is a file that `eventchain messages` has written. The plugin makes the
message packages importable, and the packages whose tests run, as an installation would; the rest is `rclpy` of this
runtime. With a sourced ROS 2, leave it out.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from eventchain_ros2 import catalog
from eventchain_ros2.messages import Messages

if TYPE_CHECKING:
    import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option that names files of message definitions."""
    help_text = "file with message definitions, written by `eventchain messages`; repeatable"
    parser.addoption("--messages", action="append", default=[], help=help_text)


def pytest_configure(config: pytest.Config) -> None:
    """Serve the imports of packages, before any test is imported."""
    Messages(catalog.read(map(Path, config.getoption("messages")))).install()
    for argument in config.args:
        place = Path(config.invocation_params.dir, argument.partition("::")[0]).resolve()
        for folder in (place, *place.parents):
            if (folder / "package.xml").is_file():
                sys.path.insert(0, str(folder))
                break
