"""What the process of a component says of constructors agrees with `inspect`, which it does without where it can."""

from __future__ import annotations

import functools
import inspect
from typing import Any

import pytest
from component_process import constructor_parameters


class Plain:
    """Has no constructor."""


class Own:
    """Has one."""

    def __init__(self, rate, /, random_source=None, *others, seed, **more):
        """Use a variable of its own."""
        variable = rate
        self.used = variable, random_source, others, seed, more


class Inherits(Own):
    """Has that of its base."""


class Overrides(Own):
    """Has another one than its base."""

    def __init__(self):
        """Take nothing."""


class Makes:
    """Takes what it is made of."""

    def __new__(cls, random_source=None):
        """Ignore it."""
        return super().__new__(cls)


def wrapped(initialize: Any) -> Any:
    """Return a function that says that it is another one."""

    @functools.wraps(initialize)
    def outer(*arguments, **named):
        return initialize(*arguments, **named)

    return outer


class Decorated:
    """Has a constructor that is wrapped."""

    @wrapped
    def __init__(self, random_source):
        """Take it."""


class Starred:
    """Takes itself as one of many."""

    def __init__(*random_source):
        """Take all."""


class Stated:
    """Says itself what it takes."""

    __signature__ = inspect.Signature([inspect.Parameter("random_source", inspect.Parameter.KEYWORD_ONLY)])

    def __init__(self, **named):
        """Take anything."""


@pytest.mark.parametrize(
    "made", [Own, Inherits, Overrides, Makes, Decorated, Starred, Stated, functools.partial(Own, 1)]
)
def test_the_parameters_of_a_constructor_are_those_of_its_signature(made: Any) -> None:
    assert set(constructor_parameters(made)) == set(inspect.signature(made).parameters)


def test_a_class_without_a_constructor_has_no_parameters() -> None:
    assert not list(constructor_parameters(Plain))
