"""Parameters of nodes, as in `rclpy.parameter`."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable
from enum import IntEnum
from math import isclose
from typing import Any


class ParameterType(IntEnum):
    """Types of parameters (rcl_interfaces/msg/ParameterType)."""

    NOT_SET = 0
    BOOL = 1
    INTEGER = 2
    DOUBLE = 3
    STRING = 4
    BYTE_ARRAY = 5
    BOOL_ARRAY = 6
    INTEGER_ARRAY = 7
    DOUBLE_ARRAY = 8
    STRING_ARRAY = 9

    @classmethod
    def from_parameter_value(cls, value: Any) -> ParameterType:
        """Return the type of a Python value.

        Raises:
            TypeError: no parameter can have this value.

        """
        if value is None:
            return cls.NOT_SET
        scalars = {bool: cls.BOOL, int: cls.INTEGER, float: cls.DOUBLE, str: cls.STRING}
        if type(value) in scalars:
            return scalars[type(value)]
        if isinstance(value, list | tuple | array):
            types = {type(item) for item in value}
            if len(types) == 1 and types <= {*scalars, bytes}:
                item_type = types.pop()
                return cls.BYTE_ARRAY if item_type is bytes else cls(scalars[item_type] + 5)
            if not types:
                return cls.BYTE_ARRAY
        raise TypeError(f"The given value is not one of the allowed types '{value!r}'.")


def parameter_value_to_python(parameter_value: Any) -> Any:
    """Return the value of a `rcl_interfaces/msg/ParameterValue`."""
    kind = ParameterType(parameter_value.type)
    return None if kind == ParameterType.NOT_SET else getattr(parameter_value, f"{kind.name.lower()}_value")


class Parameter:
    """A named value."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    Type = ParameterType

    def __init__(self, name: str, type_: ParameterType | None = None, value: Any = None) -> None:
        self.name = name
        self.type_ = ParameterType.from_parameter_value(value) if type_ is None else ParameterType(type_)
        self.value = value

    def __repr__(self) -> str:
        return f"Parameter(name={self.name!r}, type_={self.type_.name}, value={self.value!r})"

    @classmethod
    def from_parameter_msg(cls, param_msg: Any) -> Parameter:
        """Convert from `rcl_interfaces/msg/Parameter`."""
        return cls(param_msg.name, ParameterType(param_msg.value.type), parameter_value_to_python(param_msg.value))

    def to_parameter_msg(self) -> Any:
        """Convert to `rcl_interfaces/msg/Parameter`."""
        from rcl_interfaces.msg import Parameter as ParameterMessage  # type: ignore[import-not-found]

        return ParameterMessage(name=self.name, value=self.get_parameter_value())

    def get_parameter_value(self) -> Any:
        """Convert to `rcl_interfaces/msg/ParameterValue`."""
        from rcl_interfaces.msg import ParameterValue

        message = ParameterValue(type=int(self.type_))
        if self.type_ != ParameterType.NOT_SET:
            setattr(message, f"{self.type_.name.lower()}_value", self.value)
        return message


class ParameterNotDeclaredException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is used before it is declared."""


class ParameterAlreadyDeclaredException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is declared twice."""


class ParameterImmutableException(Exception):  # noqa: N818 - rclpy's name
    """A read-only parameter is undeclared."""


class InvalidParameterTypeException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is set to a value of a type other than its declared one."""


class InvalidParameterValueException(Exception):  # noqa: N818 - rclpy's name
    """The initial value of a parameter violates its descriptor."""

    def __init__(self, parameter: Parameter, reason: str) -> None:
        text = f"Invalid parameter value ({parameter.value}) for parameter '{parameter.name}'. Reason: {reason}"
        super().__init__(text)


class ParameterUninitializedException(Exception):  # noqa: N818 - rclpy's name
    """A parameter that was declared without a value is read before it is set."""


class Parameters:
    """The declared parameters of a node.

    Args:
        overrides: values that take precedence over the defaults of declarations.
        undeclared: whether a parameter may be used without a declaration.

    """

    def __init__(self, overrides: list[Parameter], *, undeclared: bool = False) -> None:
        self._overrides = {parameter.name: parameter for parameter in overrides}
        self._undeclared = undeclared
        self._declared: dict[str, Parameter] = {}
        self._descriptors: dict[str, Any] = {}
        self.before: list[Callable[[list[Parameter]], list[Parameter]]] = []
        """Callbacks that may change what is to be set."""
        self.checks: list[Callable[[list[Parameter]], Any]] = []
        """Callbacks that say whether it may be set, with a `rcl_interfaces/msg/SetParametersResult`."""
        self.after: list[Callable[[list[Parameter]], object]] = []
        """Callbacks that are told what has been set."""

    def names(self) -> list[str]:
        """Return the names of the declared parameters, in the order of their declaration."""
        return list(self._declared)

    def declare_overrides(self) -> None:
        """Declare all parameters that have a value from outside, and are not declared yet."""
        for parameter in self._overrides.values():
            if parameter.name not in self._declared:
                self.declare(parameter.name, parameter.value, dynamic=True)

    def declare(
        self,
        name: str,
        value: Any,
        descriptor: Any = None,
        *,
        ignore_override: bool = False,
        dynamic: bool = False,
    ) -> Parameter:
        """Declare a parameter.

        Args:
            name: its name.
            value: its default, or only its type.
            descriptor: a `rcl_interfaces/msg/ParameterDescriptor`; ranges, `read_only` and `dynamic_typing` are
                enforced.
            ignore_override: whether the default takes precedence over command-line values.
            dynamic: whether values of other types may be set later, as a descriptor may say, too.

        """
        if name in self._declared:
            raise ParameterAlreadyDeclaredException(f"Parameter(s) already declared: ['{name}']")
        is_type = isinstance(value, ParameterType)
        first = Parameter(name, value) if is_type else Parameter(name, value=value)
        if name in self._overrides and not ignore_override:
            _require_type(first, self._overrides[name], descriptor)
            first = self._overrides[name]
        if dynamic and descriptor is None:
            descriptor = _Dynamic
        reason = _outside(first, descriptor) or self._refusal([first])
        if reason:
            raise InvalidParameterValueException(first, reason)
        self._declared[name] = first
        self._descriptors[name] = descriptor
        self._tell([first])
        return first

    def get(self, name: str) -> Parameter:
        """Return the parameter of this name.

        Raises:
            ParameterNotDeclaredException: there is none.
            ParameterUninitializedException: it was declared with a type only, and has no value yet.

        """
        if name not in self._declared:
            if self._undeclared:
                return Parameter(name)
            raise ParameterNotDeclaredException(f"The following parameters are not declared: {name}")
        parameter = self._declared[name]
        if parameter.value is None and parameter.type_ != ParameterType.NOT_SET:
            raise ParameterUninitializedException(f"The parameter '{name}' is not initialized")
        return parameter

    def as_declared(self, name: str) -> Parameter:
        """Return a declared parameter; one that was declared with a type only, without that."""
        parameter = self._declared[name]
        return Parameter(name) if parameter.value is None else parameter

    def set(self, parameters: Iterable[Parameter]) -> str:
        """Set declared parameters to values of their types, all of them or none; return the reason for none.

        A parameter without a value is undeclared.
        """
        wanted = list(parameters)
        for change in self.before:
            wanted = change(wanted)
        for parameter in wanted:
            if parameter.name not in self._declared:
                if not self._undeclared:
                    raise ParameterNotDeclaredException(f"The following parameters are not declared: {parameter.name}")
                self.declare(parameter.name, parameter.value, dynamic=True)
            reason = self._check(parameter, self._descriptors[parameter.name])
            if reason:
                return reason
        reason = self._refusal(wanted)
        if not reason:
            self._declared.update((parameter.name, parameter) for parameter in wanted)
            self._tell(wanted)
        return reason

    def _check(self, parameter: Parameter, descriptor: Any) -> str:
        _require_type(self._declared[parameter.name], parameter, descriptor)
        if getattr(descriptor, "read_only", False):
            return f"Trying to set a read-only parameter: {parameter.name}."
        return _outside(parameter, descriptor)

    def _refusal(self, parameters: list[Parameter]) -> str:
        """Return why a callback refuses values; empty: none does."""
        for check in reversed(self.checks):
            result = check(parameters)
            if not result.successful:
                return result.reason or "a callback of the node refuses it"
        return ""

    def _tell(self, parameters: list[Parameter]) -> None:
        for callback in self.after:
            callback(parameters)

    def describe(self, name: str) -> Any:
        """Return the `rcl_interfaces/msg/ParameterDescriptor` of a parameter.

        Raises:
            ParameterNotDeclaredException: there is none.

        """
        from rcl_interfaces.msg import ParameterDescriptor

        if name not in self._declared and not self._undeclared:
            raise ParameterNotDeclaredException(f"The following parameters are not declared: {name}")
        described, stated = ParameterDescriptor(), self._descriptors.get(name)
        for field in described.__slots__:
            if hasattr(stated, field):
                setattr(described, field, getattr(stated, field))
        described.name, described.type = name, int(self.get_type(name))
        return described

    def get_type(self, name: str) -> ParameterType:
        """Return the type of a declared parameter, or `NOT_SET`."""
        return self._declared[name].type_ if name in self._declared else ParameterType.NOT_SET

    def redescribe(self, name: str, descriptor: Any) -> None:
        """Replace the descriptor of a parameter, if its value obeys the new one.

        Raises:
            InvalidParameterValueException: it does not.
            ParameterNotDeclaredException: there is no such parameter.

        """
        parameter = self.get(name)
        reason = _outside(parameter, descriptor)
        if reason:
            raise InvalidParameterValueException(parameter, reason)
        self._descriptors[name] = descriptor

    def undeclare(self, name: str) -> None:
        """Forget a parameter.

        Raises:
            ParameterNotDeclaredException: there is none.
            ParameterImmutableException: it is read-only.

        """
        if name not in self._declared:
            raise ParameterNotDeclaredException(f"The following parameters are not declared: {name}")
        if getattr(self._descriptors[name], "read_only", False):
            raise ParameterImmutableException(f"Attempted to modify read-only parameter '{name}'.")
        del self._declared[name], self._descriptors[name]

    def __contains__(self, name: str) -> bool:
        return name in self._declared


class _Dynamic:
    """The descriptor of parameters that nobody has described."""

    dynamic_typing = True
    read_only = False
    floating_point_range: tuple[Any, ...] = ()
    integer_range: tuple[Any, ...] = ()


def _require_type(current: Parameter, parameter: Parameter, descriptor: Any) -> None:
    if getattr(descriptor, "dynamic_typing", False):
        return
    if current.type_ not in (ParameterType.NOT_SET, parameter.type_):
        raise InvalidParameterTypeException(
            f"Trying to set parameter '{parameter.name}' to '{parameter.value}' of type '{parameter.type_.name}', "
            f"expecting type '{current.type_.name}'"
        )


def _outside(parameter: Parameter, descriptor: Any) -> str:
    """Return why a descriptor's range excludes a value; NaN is in no range. Bounds are inclusive."""
    kind = {ParameterType.DOUBLE: "floating_point_range", ParameterType.INTEGER: "integer_range"}.get(parameter.type_)
    if descriptor is None or kind is None or parameter.value is None:
        return ""
    for limits in getattr(descriptor, kind):
        low, high = sorted((limits.from_value, limits.to_value))
        if any(isclose(parameter.value, end) for end in (low, high)):
            continue
        if not low < parameter.value < high:
            return f"Parameter {parameter.name} doesn't comply with {kind.replace('_', ' ')}."
        if limits.step and not _on_step(parameter.value - limits.from_value, limits.step):
            return f"The parameter value for {parameter.name} is not a valid step."
    return ""


def _on_step(distance: float, step: float) -> bool:
    return isclose(distance / step, round(distance / step))
