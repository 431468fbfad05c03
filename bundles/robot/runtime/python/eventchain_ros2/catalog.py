"""The catalogue of the message types that can be used."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from eventchain_ros2 import definitions, idl_language
from eventchain_ros2.definitions import FULL_NAME, Definition, Field, MessageDefinitionError

SEPARATOR = "=" * 80 + "\n"
STANDARD_MESSAGES = Path(__file__).with_name("humble.msgs")
_LANGUAGES: dict[str, Callable[[str, str, str], Definition]] = {
    ".msg": definitions.parse,
    ".idl": idl_language.parse,
}


class Catalog:
    """The message types that can be used: the standard ones, and those in folders of the user's.

    A folder holds `<package>/msg/<Name>.msg` or `.idl`, or both, which then have to say the same. A type in a folder
    hides a standard one of that name, and one in an earlier folder.
    """

    def __init__(self, folders: Iterable[Path] = ()) -> None:
        self._texts = dict(_standard_texts())
        self._files: dict[str, list[Path]] = {}
        for folder in folders:
            found: dict[str, list[Path]] = {}
            for suffix in _LANGUAGES:
                for file in sorted(folder.glob(f"*/msg/*{suffix}")):
                    name = f"{file.parent.parent.name}/msg/{file.stem}"
                    if FULL_NAME.fullmatch(name):
                        found.setdefault(name, []).append(file)
            self._files.update(found)
        self.packages = {name.partition("/")[0] for name in (*self._texts, *self._files)}

    def names(self) -> list[str]:
        """Full names of all types, sorted."""
        return sorted({*self._texts, *self._files})

    def find(self, name: str) -> Definition | None:
        """The definition of the type with this full name.

        Raises:
            MessageDefinitionError: its file cannot be read or is no message definition, or its files differ.

        """
        if name in self._files:
            found = [_read(name, file) for file in self._files[name]]
            for other in found[1:]:
                _require_same(found[0], other)
            return found[0]
        text = self._texts.get(name)
        return None if text is None else definitions.parse(name, text, str(STANDARD_MESSAGES))


def _read(name: str, file: Path) -> Definition:
    try:
        text = file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as problem:
        raise MessageDefinitionError(f"{name} cannot be read: {problem}", str(file), 0) from None
    return _LANGUAGES[file.suffix](name, text, str(file))


def _require_same(one: Definition, other: Definition) -> None:
    if [_in_idl(field) for field in one.fields] != other.fields or {
        (constant.name, _base_in_idl(constant.base), constant.value) for constant in one.constants
    } != set(other.constants):
        problem = f"{one.name}: {Path(one.file).name} beside it says something else"
        raise MessageDefinitionError(problem, other.file, 0)


def _in_idl(field: Field) -> Field:
    return field._replace(type=field.type._replace(base=_base_in_idl(field.type.base)))


def _base_in_idl(base: str) -> str:
    """IDL has another `char`; that of the message language is written `uint8` there (rosidl)."""
    return "uint8" if base == "char" else base


def _standard_texts() -> Iterator[tuple[str, str]]:
    for part in STANDARD_MESSAGES.read_text(encoding="utf-8").split(SEPARATOR):
        heading, _, text = part.partition("\n")
        yield heading.removeprefix("MSG: "), text
