"""Callback groups, as in `rclpy.callback_groups`; each process runs one callback at a time, in any group."""

from __future__ import annotations


class CallbackGroup:
    """A group of callbacks."""

    def add_entity(self, entity: object) -> None:
        """Do nothing: groups need not know their callbacks."""

    def has_entity(self, entity: object) -> bool:
        """Return false: groups do not know their callbacks."""
        return False

    def can_execute(self, entity: object) -> bool:
        """Return whether a callback may run now."""
        return True

    def beginning_execution(self, entity: object) -> bool:
        """Return whether a callback may run now."""
        return True

    def ending_execution(self, entity: object) -> None:
        """Do nothing."""


def require_known(group: object) -> None:
    """Accept the groups of `rclpy`.

    Raises:
        NotImplementedError: it is a group of one's own, which decides itself when its callbacks run.

    """
    if not isinstance(group, MutuallyExclusiveCallbackGroup | ReentrantCallbackGroup):
        raise NotImplementedError("callback groups of one's own are not part of Eventchain's runtime")


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback at a time."""


class ReentrantCallbackGroup(CallbackGroup):
    """Callbacks that may run concurrently; here they do not."""
