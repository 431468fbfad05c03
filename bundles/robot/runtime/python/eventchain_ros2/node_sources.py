"""Imports of the user's modules, whose code is compiled once for all scenarios that import the same content.

Byte code beside a source is neither read nor written: it names the time and size of its source, and a file that is
changed within a second can keep both.
"""

from __future__ import annotations

import functools
import importlib
import importlib.machinery as machinery
import sys
from pathlib import Path
from types import CodeType
from typing import Any

RUNTIME = str(Path(__file__).resolve().parents[1])
"""The folder of this runtime."""

_MOST_FILES = 1000


_replaced: dict[str, str] = {}
"""Files that are read instead of modules, by the files of these, which stay what tracebacks name."""


class _Loader(machinery.SourceFileLoader):
    def get_code(self, fullname: str) -> CodeType:
        path = self.get_filename(fullname)
        return _compiled(self.get_data(_replaced.get(path, path)), path)


@functools.lru_cache(maxsize=_MOST_FILES)
def _compiled(content: bytes, path: str) -> CodeType:
    code: CodeType = compile(content, path, "exec", dont_inherit=True)
    return code


def text_of(path: str) -> bytes:
    """Return the content of a module's file, or of the one that is read instead."""
    return Path(_replaced.get(path, path)).read_bytes()


class NodeSources:
    """The folders of the user's modules, which change from scenario to scenario, and their place in `sys.path`."""

    def __init__(self) -> None:
        self._folders: tuple[str, ...] = ()
        self._foreign_path = [path for path in sys.path if path not in ("", str(Path.cwd()), RUNTIME)]
        self._find = machinery.FileFinder.path_hook(
            (machinery.ExtensionFileLoader, machinery.EXTENSION_SUFFIXES),
            (_Loader, machinery.SOURCE_SUFFIXES),
            (machinery.SourcelessFileLoader, machinery.BYTECODE_SUFFIXES),
        )
        sys.path_hooks.insert(0, self._hook)

    def serve(self, folders: list[str], replaced: dict[str, str]) -> None:
        """Make the modules of these folders importable, after this runtime and before those of the environment.

        Args:
            folders: the folders.
            replaced: files that are read instead of modules, by the files of these.

        """
        _replaced.clear()
        _replaced.update(replaced)
        self._folders = tuple(folder.rstrip("/") + "/" for folder in folders)
        sys.path[:] = [RUNTIME, *folders, *self._foreign_path]

    def unload(self) -> None:
        """Forget the imported modules of the folders, so that the next scenario executes them again."""
        for name, module in list(sys.modules.items()):
            places = [getattr(module, "__file__", None) or "", *getattr(module, "__path__", ())]
            if any(place.startswith(self._folders) for place in places):
                del sys.modules[name]
        importlib.invalidate_caches()

    def _hook(self, path: str) -> Any:
        if not f"{path}/".startswith(self._folders):
            raise ImportError(path)
        return self._find(path)
