"""Process of one component: it receives the arguments of execute() and returns the result.

Everything else from this process is ignored, since untrusted code runs in it: see :mod:`component_client`, the other
side. Frames in both directions are the length of the value (u32, little endian), the token of the question (4 bytes,
which the answer has, too), and a value of :mod:`component_values`, question and answer in turn:

- ``["compile", bytes]``, the content of the file, by ``["code", marshalled, line, column]``: its code, and the place of
  `execute`; none of the component's code has run in a process that is asked this first,
- ``["load", marshalled, line, column]``, which imports that code, and ``["make"]``, which makes the object, are
  answered by ``["done"]``,
- ``["call", [argument...], {name: argument...}]`` by ``["result", value, line, column]``, with the place where
  `execute` returned, or by ``["unfit", type, key, line, column]``: a value that cannot be sent; the key is null if it
  is the result itself,
- ``["series", [{name: argument...}...]]`` by ``["series", [value...]]``: the results of several calls,
- each of them by ``["raised", type, text, file, line, column]`` if the code raised something.
"""

from __future__ import annotations

import ast
import faulthandler
import importlib
import marshal
import os
import random
import struct
import sys
from collections.abc import Iterable
from signal import SIGUSR1
from types import FunctionType, ModuleType, TracebackType
from typing import Any, NoReturn

from component_rules import Component, Rules, decode
from component_values import NO_OBJECTS, PLAIN_OBJECTS, Codec, Objects

SHOW_STACK = SIGUSR1
"""The signal at which the process writes where it is."""

MESSAGE_OBJECTS = "eventchain_ros2.message_objects"
"""The module that makes messages of values; only programs with messages have it on their path."""

RANDOM_SOURCE = "random_source"
"""Parameter of a component's constructor for a `random.Random` that is the same in every run of a scenario."""

_CO_VARARGS, _CO_VARKEYWORDS = 4, 8  # as `inspect` calls the flags of code
_HEADER = struct.Struct("<I4s")
_MARKER = "_eventchain_returning"
_LONGEST_TEXT = 2000
_USUAL_QUESTION = 1 << 17


class ComponentProcess:
    """Answers the requests for one component.

    Args:
        channel: file descriptor to read questions from and to write answers to.
        description: `file`, `module` (its name), `class`, `path` (for `sys.path`), `sources` (folders or files whose
            lines are places of errors), `messages` (files with message definitions; absent: no message classes),
            `plain` (true: messages are objects without classes),
            `seed` (of its random numbers; absent: always the same ones).

    """

    def __init__(self, channel: int, description: dict[str, Any]) -> None:
        self._channel = channel
        self._buffer = memoryview(bytearray(_USUAL_QUESTION))
        self._file: str = description["file"]
        self._module_name: str = description["module"]
        self._class_name: str = description["class"]
        self._sources: list[str] = description["sources"]
        self._seed: str = description.get("seed", "")
        self._codec = Codec(_objects(description.get("messages"), description.get("plain", False)))
        self._module: ModuleType | None = None
        self._component: Any = None
        self._execute_place = 1, 1
        self._place = self._execute_place

    def serve(self) -> NoReturn:
        """Answer requests until there are no more."""
        while True:
            token, data = self._receive()
            question = self._codec.read(data)
            try:
                answer = self._answer(question)
            except BaseException as problem:  # untrusted code may raise anything
                answer = self._raised(problem)
            try:
                buffers = self._codec.write(answer)
            except TypeError:
                buffers = self._codec.write(self._unfit(answer[1]))
            _write_all(self._channel, [_HEADER.pack(sum(map(len, buffers)), token), *buffers])

    def _receive(self) -> tuple[bytes, memoryview]:
        """Return the token and the value of the next question; the value is valid until the one after that."""
        have = _read(self._channel, self._buffer)
        while have < _HEADER.size:
            have += _read(self._channel, self._buffer[have:])
        length, token = _HEADER.unpack_from(self._buffer)
        whole = length + _HEADER.size
        if whole > len(self._buffer):
            longer = memoryview(bytearray(whole))
            longer[:have] = self._buffer[:have]
            self._buffer = longer
        while have < whole:
            have += _read(self._channel, self._buffer[have:whole])
        return token, self._buffer[_HEADER.size : whole]

    def _answer(self, question: list[Any]) -> list[Any]:
        kind = question[0]
        if kind == "call":
            return self._call(*question[1:])
        if kind == "series":
            return ["series", [dict(self._component.execute(**inputs)) for inputs in question[1]]]
        if kind == "compile":
            return self._compile(question[1])
        if kind == "load":
            self._load(*question[1:])
        else:
            made = getattr(self._module, self._class_name)
            self._component = made(**self._offered(made))
        return ["done"]

    def _offered(self, made: Any) -> dict[str, Any]:
        """Return the arguments of the constructor: a source of random numbers, if it has a parameter for one."""
        return {RANDOM_SOURCE: random.Random(self._seed)} if RANDOM_SOURCE in constructor_parameters(made) else {}

    def _compile(self, content: bytes) -> list[Any]:
        """Compile the content of the file, with the `return` statements of `execute` marked."""
        source = decode(content)
        ast.parse(source, self._file)  # reports a file that is not valid Python
        rules = Rules(source, Component(self._class_name, [], []))
        rules.check()
        code = compile(rules.marked_tree(_MARKER), self._file, "exec")
        return ["code", marshal.dumps(code), *rules.execute_place()]

    def _load(self, marshalled: bytes, line: int, column: int) -> None:
        """Run the code of the file as its module."""
        package = self._module_name.rpartition(".")[0]
        if package:
            importlib.import_module(package)
        module = ModuleType(self._module_name)
        module.__file__ = self._file
        module.__package__ = package
        module.__dict__[_MARKER] = self._returning
        self._execute_place = line, column
        sys.modules[self._module_name] = self._module = module
        exec(marshal.loads(marshalled), module.__dict__)

    def _returning(self, line: int, column: int, value: Any) -> Any:
        self._place = line, column
        return value

    def _call(self, arguments: list[Any], inputs: dict[str, Any]) -> list[Any]:
        self._place = self._execute_place
        result = self._component.execute(*arguments, **inputs)
        if type(result) is not dict:
            return ["unfit", type(result).__name__, None, *self._place]
        return ["result", result, *self._place]

    def _unfit(self, result: dict[Any, Any]) -> list[Any]:
        """Report the value that cannot be sent."""
        for key, value in result.items():
            try:
                self._codec.write(value)
            except TypeError as problem:
                return ["unfit", str(problem), str(key), *self._place]
        return ["unfit", type(result).__name__, None, *self._place]

    def _raised(self, problem: BaseException) -> list[Any]:
        if isinstance(problem, SyntaxError) and problem.filename:
            place = problem.filename, problem.lineno or 0, problem.offset or 0
            text = problem.msg
        else:
            place = place_of(problem, self._sources)
            try:
                text = str(problem)
            except BaseException:
                text = ""
        return ["raised", type(problem).__name__, text[:_LONGEST_TEXT], *place]


def constructor_parameters(made: Any) -> Iterable[str]:
    """Return the names of the parameters of a constructor; none if they are not known."""
    if type(made) is type:
        defined = {name: value for base in reversed(made.__mro__[:-1]) for name, value in vars(base).items()}
        if not {"__init__", "__new__"} & defined.keys():
            return ()  # signature() would parse the text of object's, which takes longer than all the rest
        initialize = defined.get("__init__")
        # Of a plain function, signature() says the same, and to import it takes longer than all the rest.
        if type(initialize) is FunctionType and not {"__new__", "__signature__"} & defined.keys():
            code = initialize.__code__
            if code.co_argcount and not vars(initialize):
                starred = bool(code.co_flags & _CO_VARARGS) + bool(code.co_flags & _CO_VARKEYWORDS)
                return code.co_varnames[1 : code.co_argcount + code.co_kwonlyargcount + starred]
    import inspect

    try:
        return inspect.signature(made).parameters
    except (TypeError, ValueError):
        return ()


def place_of(problem: BaseException, sources: Iterable[str]) -> tuple[str, int, int]:
    """Return file, line and column (1-based, 0: unknown) of the innermost frame in one of the files or folders."""
    found = "", 0, 0
    trace = problem.__traceback__
    while trace is not None:
        file = trace.tb_frame.f_code.co_filename
        if any(file == source or file.startswith(source.rstrip("/") + "/") for source in sources):
            found = file, trace.tb_lineno, _column(trace)
        trace = trace.tb_next
    return found


def _column(trace: TracebackType) -> int:
    """Return the column of the frame's current instruction, where this Python records it (3.11 and later)."""
    if sys.version_info < (3, 11):
        return 0
    column = list(trace.tb_frame.f_code.co_positions())[trace.tb_lasti // 2][2]
    return 0 if column is None else column + 1


def _objects(files: list[str] | None, plain: bool) -> Objects:
    """The message classes of the runtime, if its package is on the path."""
    if files is None:
        return PLAIN_OBJECTS if plain else NO_OBJECTS
    objects: Objects = importlib.import_module(MESSAGE_OBJECTS).serve(files)
    return objects


def _read(channel: int, view: memoryview) -> int:
    """Read what is there; return how much."""
    count = os.readv(channel, [view])
    if count == 0:
        os._exit(0)
    return count


def _write_all(channel: int, buffers: list[Any]) -> None:
    written = os.writev(channel, buffers)
    length = sum(map(len, buffers))
    if written < length:
        rest = memoryview(b"".join(buffers))
        while written < length:
            written += os.write(channel, rest[written:])


def run(channel: int, stack: int, description: dict[str, Any]) -> NoReturn:
    """Run the process of a component.

    Args:
        channel: see :class:`ComponentProcess`.
        stack: file descriptor for the stack at :data:`SHOW_STACK`.
        description: see :class:`ComponentProcess`.

    """
    faulthandler.register(SHOW_STACK, file=stack, all_threads=False)
    sys.stdout = sys.stderr
    sys.dont_write_bytecode = True
    sys.path[:] = [*description["path"], *(entry for entry in sys.path if entry != "")]
    ComponentProcess(channel, description).serve()
