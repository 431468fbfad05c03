"""A library with a memory layout other than that of Cyclone DDS 11.0.1 is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from eventchain_ros2 import cyclone
from eventchain_ros2.cyclone import LayoutError
from eventchain_ros2.dds_entities import Participant
from wire import EVERY, STRING, TEXT, connected, take

Participants = tuple[Participant, Participant]


def change(monkeypatch: pytest.MonkeyPatch, function: str, alter: Callable[[Any, tuple[Any, ...]], None]) -> None:
    """Make a function of the library leave another result in memory."""
    library = cyclone.load()
    real = getattr(library, function)

    def changed(*arguments: Any) -> Any:
        result = real(*arguments)
        alter(result, arguments)
        return result

    monkeypatch.setattr(library, function, changed)


def without_operations(descriptor: Any) -> None:
    descriptor.number_of_operations = 0


def without_the_flag(descriptor: Any) -> None:
    descriptor.flags = 0


def with_an_empty_blob(descriptor: Any) -> None:
    descriptor.type_information.size = 0


def with_an_endless_blob(descriptor: Any) -> None:
    descriptor.type_mapping.size = 1 << 24


@pytest.mark.parametrize(
    ("alter", "problem"),
    [
        (without_operations, "the descriptor of a topic has other fields"),
        (without_the_flag, "the type information is elsewhere"),
        (with_an_empty_blob, "the type information is elsewhere"),
        (with_an_endless_blob, "the type information is elsewhere"),
    ],
)
def test_a_descriptor_of_another_layout_is_refused(
    participants: Participants, monkeypatch: pytest.MonkeyPatch, alter: Callable[[Any], None], problem: str
) -> None:
    with monkeypatch.context() as changes:
        change(changes, "dds_create_topic_descriptor", lambda _, arguments: alter(arguments[4][0]))
        with pytest.raises(LayoutError, match=f"not that of Cyclone DDS 11.0.1: {problem}"):
            participants[0].writer("/topic", STRING, EVERY)
    writer, reader = connected(participants)
    writer.write(TEXT)
    assert [each.data for each in take(reader, 1)] == [TEXT], "nothing of it is left"


def test_a_sample_whose_timestamp_is_elsewhere_is_refused(
    participants: Participants, monkeypatch: pytest.MonkeyPatch
) -> None:
    writer, reader = connected(participants)

    def alter(serialized: Any, _: tuple[Any, ...]) -> None:
        serialized.contents.source_timestamp = 7

    with monkeypatch.context() as changes:
        change(changes, "ddsi_serdata_from_ser_iov", alter)
        with pytest.raises(LayoutError, match=r"not that of Cyclone DDS 11\.0\.1: the source timestamp of a sample"):
            writer.write(TEXT, 1)
    writer.write(TEXT, 2)
    assert [each.source_timestamp for each in take(reader, 1)] == [2]
