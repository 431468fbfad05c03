"""Allowed imports between modules, as ArchUnit checks for Java, also under TYPE_CHECKING and within functions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import BUNDLE

PYTHON = BUNDLE / "python"
RUNTIME = "eventchain_ros2"
# Each module imports only from the lines above its own, so there are no cycles.
LAYERS = (
    {"definitions", "point_clouds", "transforms"},
    {"callback_groups", "clock", "cyclone", "faults", "graph", "logger", "node_sources", "parameters", "refusals"},
    {"node_parameters", "qos", "type_support", "validation"},
    {"best_available", "catalog", "codec", "dds_qos", "processes"},
    {"agenda", "dds_endpoints", "idl", "messages"},
    {"simulation"},
    {"context", "discovery", "output_faults", "tasks", "value_latency"},
    {"dds_entities"},
    {"endpoints", "failures", "message_objects", "pytest_plugin", "real_time", "service_peers", "watch"},
    {"channel", "components", "dds", "services", "wire"},
    {"node_graph"},
    {"node"},
    {"executors", "filters", "hosting", "live", "messages_once", "preparation"},
    {"__main__", "lockstep", "node_host", "transform_nodes"},
    {"transformed"},
)
LAYER_OF = {module: layer for layer, modules in enumerate(LAYERS) for module in modules}
MODULES = sorted(PYTHON.glob(f"{RUNTIME}/*.py"))
# Modules that use the library. A confined process refuses ctypes, so the modules that run in one do not use it.
WIRE = {"cyclone", "dds_endpoints", "dds_entities", "dds_qos", "discovery", "service_peers", "type_support"}
CONFINED = ("components", "executors", "simulation")
PACKAGES = ("cyclonedds", "message_filters", "rclpy", "sensor_msgs_py", "tf2_geometry_msgs", "tf2_ros")
FACADES = sorted(file for package in PACKAGES for file in PYTHON.glob(f"{package}/**/*.py"))


def imported(source: str, package: str) -> Iterator[str]:
    """Return the modules of the package that the source names in any import, `''` for the package itself."""
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
    assert [name for package in PACKAGES for name in imported(source, package)] == []


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.stem)
def test_only_the_wire_uses_the_library(module: Path) -> None:
    loads_libraries = next(imported(module.read_text(encoding="utf-8"), "ctypes"), None) is not None
    assert not loads_libraries or module.stem in WIRE


@pytest.mark.parametrize("name", CONFINED)
def test_what_runs_confined_needs_no_library(name: str) -> None:
    seen, open_ends = set(), [name]
    while open_ends:
        module = open_ends.pop()
        if module not in seen:
            seen.add(module)
            source = (PYTHON / RUNTIME / f"{module}.py").read_text(encoding="utf-8")
            open_ends += [each for each in imported(source, RUNTIME) if each]
    assert seen & WIRE == set()


@pytest.mark.parametrize("facade", FACADES, ids=lambda facade: str(facade.relative_to(PYTHON)))
def test_facades_know_nothing_of_the_host(facade: Path) -> None:
    source = facade.read_text(encoding="utf-8")
    assert (
        set(imported(source, RUNTIME))
        & {
            "",
            "channel",
            "components",
            "failures",
            "hosting",
            "lockstep",
            "node_host",
            "preparation",
            "pytest_plugin",
            "wire",
        }
        == set()
    )


def test_there_are_facades_to_check() -> None:
    assert {facade.relative_to(PYTHON).parts[0] for facade in FACADES} == set(PACKAGES)
    assert {file.parent.name for file in PYTHON.glob("*/__init__.py")} == {RUNTIME, *PACKAGES}
