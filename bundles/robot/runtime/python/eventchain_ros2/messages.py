"""Message classes, created on first use, and the import hook that serves them.

`from sensor_msgs.msg import LaserScan` works for every type of the catalog. The hook is at the end of `sys.meta_path`,
so that the packages of a sourced ROS 2 have precedence.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Mapping
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from struct import error as StructError  # noqa: N812
from types import ModuleType
from typing import Any, ClassVar

from eventchain_ros2 import codec, refusals, validation
from eventchain_ros2.catalog import REQUEST, RESPONSE, Catalog
from eventchain_ros2.definitions import Constant, Definition, FieldType, MessageDefinitionError

ENCAPSULATION = b"\x00\x01\x00\x00"  # plain CDR, little endian
_BIG_ENDIAN = b"\x00\x00"

_IDL_NAMES = {"bool": "boolean", "byte": "octet", "char": "uint8", "float32": "float", "float64": "double"}


class MalformedMessageError(ValueError):
    """Bytes that are not a CDR encoding of the expected message type."""


class Message:
    """Base of the generated classes; fields are attributes, and keyword arguments of the constructor."""

    __slots__: ClassVar[tuple[str, ...]] = ()
    _definition: ClassVar[Definition]
    _read: ClassVar[Any]
    _read_big_endian: ClassVar[Any]
    _write: ClassVar[Any]

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__slots__)
        return f"{type(self).__module__}.{type(self).__name__}({fields})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(_equal(getattr(self, name), getattr(other, name)) for name in self.__slots__)

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return names of the fields and their types, in the notation of rosidl (`sequence<float>`)."""
        return {field.name: _idl_name(field.type) for field in cls._definition.fields}


def type_name(message_class: type) -> str:
    """Return the full name of a message class (`sensor_msgs/msg/LaserScan`).

    Raises:
        TypeError: the class is not one of this runtime's.

    """
    definition = getattr(message_class, "_definition", None)
    if not isinstance(definition, Definition):
        raise TypeError(
            f"{message_class!r} is not a message class of Eventchain's runtime; "
            "classes of a sourced ROS 2 cannot be used with it (unset PYTHONPATH)"
        )
    return definition.name


def to_cdr(message: Message) -> bytearray:
    """Encode a message, with the encapsulation header.

    Raises:
        AssertionError: a field holds a value of a wrong type or out of range.

    """
    buffer = bytearray(ENCAPSULATION)
    try:
        message._write(buffer)
    except AssertionError:
        raise
    except Exception:
        validation.check(message)
        raise
    return buffer


def from_cdr(message_class: type, data: bytes | bytearray | memoryview) -> Any:
    """Decode a message from bytes with an encapsulation header, which gives the byte order.

    Raises:
        MalformedMessageError: the bytes do not encode this type.

    """
    view = memoryview(data)
    read = message_class._read  # type: ignore[attr-defined]
    if view[:2] != ENCAPSULATION[:2]:
        if view[:2] != _BIG_ENDIAN:
            raise MalformedMessageError(f"{type_name(message_class)}: only plain CDR can be read")
        read = message_class._read_big_endian  # type: ignore[attr-defined]
    try:
        message, end = read(view[4:], 0)
    except (StructError, ValueError) as problem:
        raise MalformedMessageError(f"{type_name(message_class)}: {problem}") from problem
    if end > len(view) - 4:
        raise MalformedMessageError(f"{type_name(message_class)}: {end + 4 - len(view)} bytes are missing")
    return message


class Messages(MetaPathFinder, Loader):
    """The classes of a catalogue, and the finder of the modules that hold them; see `Catalog`.

    Args:
        own: the definitions of a `Catalog`, or what returns them once they are needed.

    """

    def __init__(self, own: Mapping[str, Any] | Callable[[], Mapping[str, Any]] | None = None) -> None:
        self._own = own
        self._classes: dict[str, type] = {}
        self._unfinished: list[str] = []

    @functools.cached_property
    def catalog(self) -> Catalog:
        """Return the catalogue."""
        return Catalog(self._own() if callable(self._own) else self._own)

    def get(self, name: str) -> type:
        """Return the class of a message type, by its full name.

        Raises:
            KeyError: no such type.
            MessageDefinitionError: its definition, or that of a nested type, is invalid.

        """
        if name not in self._classes:
            definition = self.catalog.find(name)
            if definition is None:
                raise KeyError(name)
            if name in self._unfinished:
                raise MessageDefinitionError(f"{name} contains itself")
            self._unfinished.append(name)
            self._classes[name] = self._make(definition)
            self._unfinished.remove(name)
        return self._classes[name]

    def _make(self, definition: Definition) -> type:
        package, kind, short_name = definition.name.split("/")
        namespace: dict[str, Any] = {constant.name: _constant(constant) for constant in definition.constants}
        namespace["__slots__"] = tuple(field.name for field in definition.fields)
        namespace["__module__"] = f"{package}.{kind}"
        namespace["_definition"] = definition
        message_class: Any = type(short_name, (Message,), namespace)
        functions = codec.generate(definition, message_class, self.get)
        message_class.__init__ = functions.initialize
        message_class._write = functions.write
        message_class._read = staticmethod(functions.read)
        message_class._read_big_endian = functions.read_big_endian
        return message_class  # type: ignore[no-any-return]

    def install(self) -> None:
        """Serve imports, instead of a previously installed catalog."""
        others = [finder for finder in sys.meta_path if type(finder) is not Messages]
        if len(others) < len(sys.meta_path):
            for name, module in list(sys.modules.items()):
                if isinstance(module, _Served):
                    del sys.modules[name]
            sys.meta_path[:] = others
        sys.meta_path.append(self)

    def find_spec(self, fullname: str, path: object, target: object = None) -> ModuleSpec | None:
        """Find `package`, `package.msg` and `package.srv` for each package of the catalog.

        Raises:
            ModuleNotFoundError: a module of ROS 2 that is not part of this runtime, which the message says.

        """
        package, _, rest = fullname.partition(".")
        members = {"": self.catalog.has_package, "msg": self.catalog.members, "srv": self.catalog.services}
        if rest not in members or not members[rest](package):
            refusals.refuse(fullname)
            return None
        return ModuleSpec(fullname, self, is_package=not rest)

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Create the module; its classes are created on access."""
        modules = {"": _MessagePackage, "msg": _MessageModule, "srv": _ServiceModule}
        return modules[spec.name.partition(".")[2]](spec.name, self)

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing: there is no code to run."""


class _Served(ModuleType):
    """A module of this finder."""

    def __init__(self, name: str, messages: Messages) -> None:
        super().__init__(name)
        self._messages = messages


class _MessagePackage(_Served):
    """A package of messages and services."""


class _MessageModule(_Served):
    """The message types of a package."""

    def __getattr__(self, name: str) -> Any:
        package = self.__name__.partition(".")[0]
        if name == "__all__":
            return self._messages.catalog.members(package)
        try:
            message_class = self._messages.get(f"{package}/msg/{name}")
        except KeyError as missing:
            text = f"module '{self.__name__}' has no message '{name}'"
            if missing.args[0] != f"{package}/msg/{name}":
                text = f"message '{package}/msg/{name}' contains the unknown message '{missing.args[0]}'"
            raise AttributeError(text) from None
        setattr(self, name, message_class)
        return message_class


class _ServiceModule(_Served):
    """The service types of a package: classes with the message types `Request` and `Response`."""

    def __getattr__(self, name: str) -> Any:
        package = self.__name__.partition(".")[0]
        known = self._messages.catalog.services(package)
        if name == "__all__":
            return known
        if name not in known:
            raise AttributeError(f"module '{self.__name__}' has no service '{name}'")
        parts = {"Request": f"{name}{REQUEST}", "Response": f"{name}{RESPONSE}"}
        members = {part: self._messages.get(f"{package}/srv/{each}") for part, each in parts.items()}
        service = type(name, (), {"__module__": self.__name__, **members})
        setattr(self, name, service)
        return service


def _constant(constant: Constant) -> Any:
    return codec.python_value(constant.base, constant.value)


def _equal(one: Any, other: Any) -> bool:
    result = one == other
    return bool(result.all()) if hasattr(result, "all") else bool(result)


def _idl_name(field_type: FieldType) -> str:
    name = _IDL_NAMES.get(field_type.base, field_type.base).replace("/msg/", "/")
    if field_type.string_bound:
        name += f"<{field_type.string_bound}>"
    if field_type.kind == "array":
        return f"{name}[{field_type.size}]"
    if field_type.kind == "sequence":
        return f"sequence<{name}, {field_type.size}>" if field_type.size else f"sequence<{name}>"
    return name
