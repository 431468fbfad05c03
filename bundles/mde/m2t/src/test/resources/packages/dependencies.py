"""Compares the imports of a ROS 2 package with the dependencies in its package.xml: python dependencies.py FOLDER.

Prints the imports without a dependency.
"""

import ast
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

# Keys of rosdep for modules that are not from ROS 2 packages.
KEYS = {"numpy": "python3-numpy", "pytest": "python3-pytest", "setuptools": "python3-setuptools"}


def imported(file):
    """Yields the top-level names of the absolute imports of a file."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.partition(".")[0]


def main(folder):
    """Prints the missing dependencies."""
    root = ElementTree.parse(folder / "package.xml").getroot()
    named = {each.text for each in root if each.tag.endswith("_depend")}
    own = {root.findtext("name"), "conftest"}
    found = {name for file in folder.rglob("*.py") for name in imported(file)}
    found -= set(sys.stdlib_module_names) | own
    assert {"rclpy", "launch", "pytest", "setuptools"} <= found, found
    print(sorted(name for name in found if KEYS.get(name, name) not in named))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
