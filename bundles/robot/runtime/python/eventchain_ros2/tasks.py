"""Futures and tasks as in `rclpy.task`: results that come later, and callbacks that wait for them.

A callback that is a coroutine runs until it waits for a future. When the future has its result, it continues as a
further callback of its process, in the order of the simulation, so that runs are reproducible.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator
from functools import partial
from types import CoroutineType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from eventchain_ros2.simulation import Process, Simulation


class Future:
    """A result that is not there yet; `await` waits for it."""

    def __class_getitem__(cls, item: object) -> type:
        return cls

    def __init__(self, *, executor: object = None) -> None:
        self._is_done = False
        self._is_cancelled = False
        self._result: Any = None
        self._exception: BaseException | None = None
        self._callbacks: list[Callable[[Future], object]] = []
        self._lock = threading.Lock()

    def __await__(self) -> Generator[Future, None, Any]:
        while not self._is_done:
            yield self
        return self.result()

    def done(self) -> bool:
        """Return whether there is a result, an exception or a cancellation."""
        return self._is_done

    def cancelled(self) -> bool:
        """Return whether it was cancelled."""
        return self._is_cancelled

    def cancel(self) -> None:
        """Stop waiting for a result."""
        if not self._is_done:
            self._is_cancelled = True
            self._finish()

    def result(self) -> Any:
        """Return the result, None without one; raise the exception if there is one."""
        if self._exception is not None:
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        """Return the exception, if there is one."""
        return self._exception

    def set_result(self, result: Any) -> None:
        """Set the result, and call those that wait for it."""
        self._result = result
        self._finish()

    def set_exception(self, exception: BaseException) -> None:
        """Set an exception instead of a result."""
        self._exception = exception
        self._finish()

    def add_done_callback(self, callback: Callable[[Future], object]) -> None:
        """Call this with the future when it is done, or now if it is."""
        with self._lock:
            is_done = self._is_done
            if not is_done:
                self._callbacks.append(callback)
        if is_done:
            callback(self)

    def _finish(self) -> None:
        with self._lock:
            self._is_done = True
            callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            callback(self)


class Task(Future):
    """A function or coroutine that an executor runs; its result is that of the function.

    Args:
        handler: the function, coroutine function or coroutine.
        args: its arguments.
        kwargs: its keyword arguments.
        again: calls a function later, as a further callback.

    """

    def __init__(
        self,
        handler: Any,
        args: tuple[Any, ...] = (),
        kwargs: dict[str, Any] | None = None,
        *,
        again: Callable[[Callable[[], None]], None],
    ) -> None:
        super().__init__()
        self._handler: Any = handler if _is_coroutine(handler) else partial(handler, *args, **kwargs or {})
        self._again = again

    def __call__(self) -> None:
        """Run until the function has ended, or waits.

        Raises:
            BaseException: what the function raises, which is then the exception of this task, too.

        """
        if self.done():
            return
        try:
            self._advance()
        except Exception as error:
            self.set_exception(error)
            raise

    def _advance(self) -> None:
        if not _is_coroutine(self._handler):
            result = self._handler()
            if not _is_coroutine(result):
                self.set_result(result)
                return
            self._handler = result
        try:
            awaited = self._handler.send(None)
        except StopIteration as end:
            self.set_result(end.value)
            return
        if isinstance(awaited, Future):
            awaited.add_done_callback(lambda _: self._again(self))
        else:
            self._again(self)

    def cancel(self) -> None:
        """Do not continue."""
        if _is_coroutine(self._handler):
            self._handler.close()
        super().cancel()


def _is_coroutine(value: object) -> bool:
    return type(value) is CoroutineType


def run(simulation: Simulation, process: Process, handler: Any, *args: Any, **kwargs: Any) -> Task:
    """Return the task of a function, which runs as a further callback of a process."""
    task = Task(handler, args, kwargs, again=partial(simulation.call, process))
    simulation.call(process, task)
    return task


def follow(
    simulation: Simulation, process: Process, result: object, then: Callable[[Any], object] | None = None
) -> None:
    """Continue the coroutine that a callback has returned, in the callback; other results are ignored.

    Args:
        simulation: the simulation of the callback.
        process: the process that runs the callback.
        result: what the callback has returned.
        then: called with the result of the coroutine, or at once with any other.

    """
    if not _is_coroutine(result):
        if then is not None:
            then(result)
        return
    task = Task(result, again=partial(simulation.call, process))
    if then is not None:
        task.add_done_callback(lambda done: then(done.result()) if done.exception() is None else None)
    task()
