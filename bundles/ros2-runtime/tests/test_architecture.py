"""Who may import whom: what ArchUnit holds for the Java bundles, also under TYPE_CHECKING and within functions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import BUNDLE

PYTHON = BUNDLE / "python"
RUNTIME = "eventchain_ros2"
# Each module imports only from the lines above its own, so there are no circles.
LAYERS = (
    {"clock", "definitions", "logger", "parameters"},
    {"qos", "validation"},
    {"codec", "simulation"},
    {"context", "idl", "messages"},
    {"endpoints", "failures", "message_objects", "pytest_plugin"},
    {"components", "dds", "node"},
    {"executors", "lockstep"},
)
LAYER_OF = {module: layer for layer, modules in enumerate(LAYERS) for module in modules}
MODULES = sorted(PYTHON.glob(f"{RUNTIME}/*.py"))
FACADES = sorted([*PYTHON.glob("rclpy/**/*.py"), *PYTHON.glob("cyclonedds/**/*.py")])


def imported(source: str, package: str) -> Iterator[str]:
    """The modules of the package that the source names in any import, `''` for the package itself."""
    for statement in ast.walk(ast.parse(source)):
        names: list[str] = []
        if isinstance(statement, ast.Import):
            names = [alias.name for alias in statement.names]
        elif isinstance(statement, ast.ImportFrom):
            assert not statement.level, "imports are absolute"
            module = statement.module or ""
            names = [f"{module}.{alias.name}" for alias in statement.names] if module == package else [module]
        for name in names:
            first, _, rest = name.partition(".")
            if first == package:
                yield rest.partition(".")[0]


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("import eventchain_ros2.qos as q, numpy", ["qos"]),
        ("from eventchain_ros2 import context, qos", ["context", "qos"]),
        ("if TYPE_CHECKING:\n    from eventchain_ros2.node import Node", ["node"]),
        ("def f():\n    import eventchain_ros2", [""]),
        ("from rclpy.node import Node", []),
    ],
)
def test_imports_are_found_wherever_they_stand(source: str, expected: list[str]) -> None:
    assert list(imported(source, RUNTIME)) == expected


def test_every_module_has_a_layer() -> None:
    assert {module.stem for module in MODULES} - {"__init__"} == set(LAYER_OF)


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.stem)
def test_imports_point_upwards(module: Path) -> None:
    source = module.read_text(encoding="utf-8")
    layer = LAYER_OF.get(module.stem, 0)
    assert [name for name in imported(source, RUNTIME) if LAYER_OF.get(name, layer) >= layer] == []


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.stem)
def test_runtime_knows_no_facade(module: Path) -> None:
    source = module.read_text(encoding="utf-8")
    assert [*imported(source, "rclpy"), *imported(source, "cyclonedds")] == []


@pytest.mark.parametrize("facade", FACADES, ids=lambda facade: str(facade.relative_to(PYTHON)))
def test_facades_know_nothing_of_the_host(facade: Path) -> None:
    source = facade.read_text(encoding="utf-8")
    assert set(imported(source, RUNTIME)) & {"", "components", "failures", "lockstep", "pytest_plugin"} == set()


def test_there_are_facades_to_check() -> None:
    assert {facade.relative_to(PYTHON).parts[0] for facade in FACADES} == {"rclpy", "cyclonedds"}
