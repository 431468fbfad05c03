"""Loggers of nodes: one line per message on standard error, with the simulated time."""

from __future__ import annotations

import sys
from collections.abc import Callable
from enum import IntEnum


class LoggingSeverity(IntEnum):
    """Levels, as in `rclpy.logging`."""

    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


class Logger:
    """A logger with rclpy's conditions `once`, `skip_first` and `throttle_duration_sec`.

    A condition belongs to the logging source line; its throttle uses simulated time.
    """

    def __init__(self, name: str, now: Callable[[], int]) -> None:
        self.name = name
        self._now = now
        self._level = LoggingSeverity.INFO
        self._lines: dict[tuple[str, int], int] = {}  # time of the last message of each conditional line

    def get_child(self, name: str) -> Logger:
        """Return a logger below this one."""
        return Logger(f"{self.name}.{name}", self._now)

    def set_level(self, level: LoggingSeverity) -> None:
        """Drop messages below this level."""
        self._level = LoggingSeverity(level)

    def get_effective_level(self) -> LoggingSeverity:
        """Return the level below which messages are dropped."""
        return self._level

    def is_enabled_for(self, severity: LoggingSeverity) -> bool:
        """Return whether messages of this level are shown."""
        return severity >= self._level

    def debug(self, message: str, **conditions: object) -> bool:
        """Log details for debugging."""
        return self._log(LoggingSeverity.DEBUG, message, conditions)

    def info(self, message: str, **conditions: object) -> bool:
        """Log normal operation."""
        return self._log(LoggingSeverity.INFO, message, conditions)

    def warning(self, message: str, **conditions: object) -> bool:
        """Log a possible problem."""
        return self._log(LoggingSeverity.WARN, message, conditions)

    def warn(self, message: str, **conditions: object) -> bool:
        """Log a possible problem."""
        return self._log(LoggingSeverity.WARN, message, conditions)

    def error(self, message: str, **conditions: object) -> bool:
        """Log an error."""
        return self._log(LoggingSeverity.ERROR, message, conditions)

    def fatal(self, message: str, **conditions: object) -> bool:
        """Log an error that ends the node."""
        return self._log(LoggingSeverity.FATAL, message, conditions)

    def log(self, message: str, severity: LoggingSeverity, **conditions: object) -> bool:
        """Log with a level."""
        return self._log(LoggingSeverity(severity), message, conditions)

    def _log(self, severity: LoggingSeverity, message: str, conditions: dict[str, object]) -> bool:
        if severity < self._level or (conditions and not self._holds(conditions)):
            return False
        seconds, nanoseconds = divmod(self._now(), 1_000_000_000)
        print(f"[{severity.name}] [{seconds}.{nanoseconds:09}] [{self.name}]: {message}", file=sys.stderr)
        return True

    def _holds(self, conditions: dict[str, object]) -> bool:
        unknown = set(conditions) - {"once", "skip_first", "throttle_duration_sec", "throttle_time_source_type"}
        if unknown:
            raise TypeError(f"unknown logging condition: {', '.join(sorted(unknown))}")
        caller = sys._getframe(3)
        line = caller.f_code.co_filename, caller.f_lineno
        last, now = self._lines.get(line), self._now()
        throttle = conditions.get("throttle_duration_sec", 0)
        if last is None:
            self._lines[line] = now
            return not conditions.get("skip_first")
        if conditions.get("once") or (isinstance(throttle, int | float) and now - last < throttle * 1e9):
            return False
        self._lines[line] = now
        return True
