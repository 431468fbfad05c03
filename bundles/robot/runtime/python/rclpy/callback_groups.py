"""As `rclpy.callback_groups`; each process runs one callback at a time, in any group."""


class CallbackGroup:
    """A group of callbacks."""


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback at a time."""


class ReentrantCallbackGroup(CallbackGroup):
    """Callbacks that may run concurrently; here they do not."""


__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]
