"""Run a single node file based on rclpy in real time on DDS.

python -m eventchain_ros2 [--messages FILE]... NODE.py [--ros-args -p [NODE:]NAME:=VALUE --params-file FILE ...]

FILE holds message definitions, as `eventchain messages` writes them. The domain is that of `ROS_DOMAIN_ID`, and
`CYCLONEDDS_URI` configures it. `-p use_sim_time:=true` lets the node live in the time of `/clock`.
"""

from __future__ import annotations

import os
import runpy
import sys
import traceback
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from eventchain_ros2.node_sources import RUNTIME

if TYPE_CHECKING:
    from collections.abc import Iterator

    from eventchain_ros2.parameters import Parameter

UNAVAILABLE = 3
USAGE = """usage: python -m eventchain_ros2 [--messages FILE]... NODE.py
         [--ros-args -p [NODE:]NAME:=VALUE | --params-file FILE ...]"""


class UsageError(Exception):
    """The command line is invalid."""


class Command(NamedTuple):
    """Contents of the command line: files with messages, the file, its arguments, `(node, name, value)` of parameters.

    A parameter without a node applies to all nodes; the last value takes precedence.
    """

    messages: list[Path]
    node: Path
    arguments: list[str]
    parameters: list[tuple[str, str, Any]]


def parse(arguments: list[str]) -> Command:
    """Parse the command line.

    Raises:
        UsageError: it is invalid.

    """
    rest, messages = list(arguments), []
    while rest and rest[0].startswith("-"):
        option = rest.pop(0)
        if option != "--messages" or not rest:
            raise UsageError(f"unexpected argument {option}")
        messages.append(Path(rest.pop(0)))
    if not rest:
        raise UsageError("there is no file to run")
    node, rest = Path(rest[0]), rest[1:]
    if not node.is_file():
        raise UsageError(f"there is no file {node}")
    return Command(messages, node, rest, list(_parameters(rest)))


def _parameters(arguments: list[str]) -> list[tuple[str, str, Any]]:
    found: list[tuple[str, str, Any]] = []
    rest = iter(arguments)
    for argument in rest:
        if argument != "--ros-args":
            continue  # an argument of the file itself
        for option in rest:
            if option == "--":
                break
            if option in ("-p", "--param"):
                found.append(_parameter(next(rest, "")))
            elif option == "--params-file":
                found += _parameters_of_file(Path(next(rest, "")))
            else:
                known = "-p and --params-file"
                raise UsageError(
                    f"{option} is not part of Eventchain's runtime; behind --ros-args there may be {known}"
                )
    return found


def _parameter(text: str) -> tuple[str, str, Any]:
    name, assigned, value = text.partition(":=")
    if not assigned or not name:
        raise UsageError("-p wants NAME:=VALUE")
    node, colon, own_name = name.rpartition(":")
    return node.lstrip("/") if colon else "", own_name, _yaml(value, f"the value of parameter {name}")


def _parameters_of_file(file: Path) -> list[tuple[str, str, Any]]:
    """Return the parameters of a file `NODE: {ros__parameters: {NAME: VALUE}}`, with `/**` for all nodes."""
    try:
        content = _yaml(file.read_text(encoding="utf-8"), str(file))
    except (OSError, UnicodeDecodeError) as problem:
        raise UsageError(f"{file} cannot be read: {problem}") from None
    found: list[tuple[str, str, Any]] = []
    for node, values in content.items() if isinstance(content, dict) else [("", content)]:
        if not isinstance(values, dict) or list(values) != ["ros__parameters"]:
            raise UsageError(f"{file}: below the name of a node there has to be ros__parameters, and nothing else")
        name = "" if node == "/**" else str(node).rpartition("/")[2]
        if "*" in name:
            raise UsageError(f"{file}: {node} is not part of Eventchain's runtime, but /** is")
        found += [(name, *each) for each in _named(values["ros__parameters"] or {}, "")]
    return found


def _named(values: dict[str, Any], prefix: str) -> Iterator[tuple[str, Any]]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _named(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def _yaml(text: str, what: str) -> Any:
    from ruamel.yaml import YAML
    from ruamel.yaml.error import YAMLError

    try:
        return YAML(typ="safe", pure=True).load(text)
    except YAMLError:
        raise UsageError(f"{what} is not YAML: {text}") from None


def domain(asked: int | None) -> int:
    """Return the domain number: the one passed to `rclpy.init`, or that of `ROS_DOMAIN_ID`, or 0.

    Raises:
        UsageError: `ROS_DOMAIN_ID` is not a number.

    """
    text = os.environ.get("ROS_DOMAIN_ID") or "0"
    if asked is None and not text.isdecimal():
        raise UsageError(f"ROS_DOMAIN_ID is not a number: {text}")
    return int(text) if asked is None else asked


def run(command: Command) -> None:
    """Run the file as `python` would, with our `rclpy`."""
    from eventchain_ros2 import catalog, context, cyclone, refusals
    from eventchain_ros2.dds_entities import Participant
    from eventchain_ros2.live import Live
    from eventchain_ros2.messages import Messages

    cyclone.load()
    domain(None)
    messages = Messages(catalog.read(command.messages))
    messages.install()
    overrides = [(node, _override(name, value)) for node, name, value in command.parameters]
    worlds: list[Live] = []

    def start(asked: int | None) -> Live:
        worlds.append(Live(Participant(domain(asked), catalog=messages.catalog), overrides))
        return worlds[-1]

    context.start_with(start)
    sys.argv = [str(command.node), *command.arguments]
    sys.path[:] = [RUNTIME, str(_root(command.node)), *(path for path in sys.path[1:] if path != RUNTIME)]
    try:
        runpy.run_path(str(command.node), run_name="__main__")
    except ImportError as missing:
        if not refusals.hint(missing):
            raise
        traceback.print_exc()
        raise SystemExit(f"hint: {refusals.hint(missing)}") from None
    finally:
        for world in worlds:
            world.close()


def _override(name: str, value: Any) -> Parameter:
    from eventchain_ros2.parameters import Parameter

    try:
        return Parameter(name, value=value)
    except TypeError:
        raise UsageError(f"parameter {name} cannot have the value {value!r}") from None


def _root(node: Path) -> Path:
    """Return the folder for imports: that of the file, or the one that contains its package."""
    folder = node.resolve().parent
    while (folder / "__init__.py").is_file():
        folder = folder.parent
    return folder


def main() -> int:
    """Run the command line; return 2 if it, or a message definition, is invalid, 3 if there is no Cyclone DDS."""
    from eventchain_ros2.cyclone import LibraryUnavailableError
    from eventchain_ros2.definitions import MessageDefinitionError

    try:
        run(parse(sys.argv[1:]))
    except UsageError as problem:
        print(f"error: {problem}\n{USAGE}", file=sys.stderr)
        return 2
    except MessageDefinitionError as problem:
        print(f"error: {problem}", file=sys.stderr)
        return 2
    except LibraryUnavailableError as problem:
        print(f"error: {problem}\nhint: {problem.hint}", file=sys.stderr)
        return UNAVAILABLE
    return 0


if __name__ == "__main__":
    sys.exit(main())
