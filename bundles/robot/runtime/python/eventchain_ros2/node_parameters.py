"""The methods of nodes about their parameters."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from eventchain_ros2.parameters import Parameter, Parameters, ParameterType


class ParameterMethods:
    """A node's parameters, as `rclpy.node.Node` has them."""

    def _start_parameters(self, overrides: list[Parameter], *, undeclared: bool) -> None:
        self.__parameters = Parameters(overrides, undeclared=undeclared)

    def _declare_overrides(self) -> None:
        self.__parameters.declare_overrides()

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: object = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare a parameter with its default value; ranges and `read_only` of the descriptor are enforced."""
        return self.__parameters.declare(name, value, descriptor, ignore_override=ignore_override)

    def declare_parameters(self, namespace: str, parameters: list[tuple[Any, ...]]) -> list[Parameter]:
        """Declare several parameters, given as `(name, value, descriptor)`, where the last ones are optional."""
        prefix = f"{namespace}." if namespace else ""
        return [self.__parameters.declare(prefix + name, *rest or [None]) for name, *rest in parameters]

    def has_parameter(self, name: str) -> bool:
        """Return whether the parameter is declared."""
        return name in self.__parameters

    def get_parameter(self, name: str) -> Parameter:
        """Return the declared parameter of this name."""
        return self.__parameters.get(name)

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return the declared parameter of this name; without one, the alternative, or a parameter without a value."""
        if name in self.__parameters:
            return self.__parameters.get(name)
        return Parameter(name) if alternative_value is None else alternative_value

    def undeclare_parameter(self, name: str) -> None:
        """Forget a declared parameter that is not read-only."""
        self.__parameters.undeclare(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return the declared parameters of these names."""
        return [self.__parameters.get(name) for name in names]

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters whose names begin with a prefix and a dot, by the rest of their names."""
        start = f"{prefix}." if prefix else ""
        names = [name for name in self.__parameters.names() if name.startswith(start)]
        return {name[len(start) :]: self.__parameters.as_declared(name) for name in names}

    def list_parameters(self, prefixes: list[str], depth: int) -> Any:
        """Return a `rcl_interfaces/msg/ListParametersResult`.

        Args:
            prefixes: beginnings of names, which end before a dot; empty: all.
            depth: the largest number of parts of a name behind its prefix; 0: no limit.

        """
        from rcl_interfaces.msg import ListParametersResult  # type: ignore[import-not-found]

        names = [
            name
            for name in self.__parameters.names()
            if any(_is_below(name, prefix, depth) for prefix in prefixes or [""])
        ]
        parents = {name.rpartition(".")[0] for name in names} - {""}
        return ListParametersResult(names=names, prefixes=sorted(parents))

    def get_parameter_type(self, name: str) -> ParameterType:
        """Return the type of a parameter."""
        return self.__parameters.get_type(name)

    def get_parameter_types(self, names: list[str]) -> list[ParameterType]:
        """Return the types of parameters."""
        return [self.__parameters.get_type(name) for name in names]

    def set_parameters(self, parameters: list[Parameter]) -> list[Any]:
        """Set declared parameters one by one; return a `rcl_interfaces/msg/SetParametersResult` for each."""
        return [self.set_parameters_atomically([parameter]) for parameter in parameters]

    def set_parameters_atomically(self, parameters: list[Parameter]) -> Any:
        """Set declared parameters, all or none; return a `rcl_interfaces/msg/SetParametersResult`."""
        from rcl_interfaces.msg import SetParametersResult

        reason = self.__parameters.set(parameters)
        return SetParametersResult(successful=not reason, reason=reason)

    def describe_parameter(self, name: str) -> Any:
        """Return the `rcl_interfaces/msg/ParameterDescriptor` of a parameter."""
        return self.__parameters.describe(name)

    def describe_parameters(self, names: list[str]) -> list[Any]:
        """Return the descriptors of parameters."""
        return [self.__parameters.describe(name) for name in names]

    def set_descriptor(self, name: str, descriptor: Any, alternative_value: Any = None) -> Any:
        """Replace the descriptor of a parameter, and its value if there is another; return its value as a message."""
        if alternative_value is not None:
            self.__parameters.set([Parameter(name, value=alternative_value)])
        self.__parameters.redescribe(name, descriptor)
        return self.__parameters.get(name).get_parameter_value()

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Let a callback change what is to be set."""
        self.__parameters.before.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Let a callback say whether values may be set, with a `rcl_interfaces/msg/SetParametersResult`."""
        self.__parameters.checks.append(callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], object]) -> None:
        """Tell a callback what has been set."""
        self.__parameters.after.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Remove a callback."""
        self.__parameters.before.remove(callback)

    def remove_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Remove a callback."""
        self.__parameters.checks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], object]) -> None:
        """Remove a callback."""
        self.__parameters.after.remove(callback)


def _is_below(name: str, prefix: str, depth: int) -> bool:
    if name == prefix:
        return True
    start = f"{prefix}." if prefix else ""
    return name.startswith(start) and (not depth or name[len(start) :].count(".") < depth)
