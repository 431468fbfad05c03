"""Parameters of nodes, as in `rclpy.parameter`."""

from __future__ import annotations

from array import array
from enum import IntEnum
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
        """The type of a Python value.

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


class Parameter:
    """A named value."""

    Type = ParameterType

    def __init__(self, name: str, type_: ParameterType | None = None, value: Any = None) -> None:
        self.name = name
        self.type_ = ParameterType.from_parameter_value(value) if type_ is None else ParameterType(type_)
        self.value = value

    def __repr__(self) -> str:
        return f"Parameter(name={self.name!r}, type_={self.type_.name}, value={self.value!r})"

    def get_parameter_value(self) -> Any:
        """As `rcl_interfaces/msg/ParameterValue`."""
        from rcl_interfaces.msg import ParameterValue  # type: ignore[import-not-found]

        message = ParameterValue(type=int(self.type_))
        if self.type_ != ParameterType.NOT_SET:
            setattr(message, f"{self.type_.name.lower()}_value", self.value)
        return message


class ParameterNotDeclaredException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is used before it is declared."""


class ParameterAlreadyDeclaredException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is declared twice."""


class InvalidParameterTypeException(Exception):  # noqa: N818 - rclpy's name
    """A parameter is set to a value of another type than it was declared with."""


class Parameters:
    """The declared parameters of a node."""

    def __init__(self, overrides: list[Parameter]) -> None:
        self._overrides = {parameter.name: parameter for parameter in overrides}
        self._declared: dict[str, Parameter] = {}

    def declare(self, name: str, value: Any) -> Parameter:
        """Declare a parameter; `value` is its default, or only its type."""
        if name in self._declared:
            raise ParameterAlreadyDeclaredException(f"Parameter(s) already declared: ['{name}']")
        is_type = isinstance(value, ParameterType)
        self._declared[name] = Parameter(name, value) if is_type else Parameter(name, value=value)
        if name in self._overrides:
            self.set(self._overrides[name])
        return self._declared[name]

    def get(self, name: str) -> Parameter:
        """The parameter of this name."""
        if name not in self._declared:
            raise ParameterNotDeclaredException(f"The following parameters are not declared: {name}")
        return self._declared[name]

    def set(self, parameter: Parameter) -> None:
        """Give a declared parameter a new value of its type."""
        current = self.get(parameter.name)
        if current.type_ not in (ParameterType.NOT_SET, parameter.type_):
            raise InvalidParameterTypeException(
                f"Trying to set parameter '{parameter.name}' to '{parameter.value}' of type '{parameter.type_.name}', "
                f"expecting type '{current.type_.name}'"
            )
        self._declared[parameter.name] = parameter

    def __contains__(self, name: str) -> bool:
        return name in self._declared
