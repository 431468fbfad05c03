"""Parameters with descriptors, as nodes declare them to be set from files and command lines."""

from __future__ import annotations

from typing import Any

import pytest
from eventchain_ros2.simulation import Simulation
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.node import Node
from rclpy.parameter import Parameter


def node(**overrides: Any) -> Node:
    return Node("node", parameter_overrides=[Parameter(name, value=value) for name, value in overrides.items()])


def limits(low: float, high: float, step: float = 0.0, **options: Any) -> Any:
    from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor

    span = FloatingPointRange(from_value=low, to_value=high, step=step)
    return ParameterDescriptor(floating_point_range=[span], **options)


@pytest.mark.parametrize("value", [0.5, 7.0, 10.0])
def test_values_of_a_range_with_its_ends_are_taken(simulation: Simulation, value: float) -> None:
    assert node(rate=value).declare_parameter("rate", 1.0, limits(0.5, 10.0)).value == value


@pytest.mark.parametrize("value", [0.0, -1.0, 10.5, float("nan"), float("inf")])
def test_values_outside_of_a_range_are_refused(simulation: Simulation, value: float) -> None:
    started = node(rate=value)
    with pytest.raises(InvalidParameterValueException, match="rate doesn't comply with floating point range"):
        started.declare_parameter("rate", 1.0, limits(0.5, 10.0))
    assert not started.has_parameter("rate")
    running = node()
    running.declare_parameter("rate", 1.0, limits(0.5, 10.0))
    (result,) = running.set_parameters([Parameter("rate", value=value)])
    assert not result.successful
    assert "comply" in result.reason
    assert running.get_parameter("rate").value == 1.0


def test_values_between_steps_are_refused(simulation: Simulation) -> None:
    started = node()
    started.declare_parameter("rate", 1.0, limits(0.0, 10.0, 0.5))
    results = started.set_parameters([Parameter("rate", value=value) for value in (1.5, 1.6, 10.0)])
    assert [result.successful for result in results] == [True, False, True]


def test_integers_have_ranges_too(simulation: Simulation) -> None:
    from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

    span = IntegerRange(from_value=1, to_value=9, step=2)
    started = node(count=4)
    with pytest.raises(InvalidParameterValueException, match="step"):
        started.declare_parameter("count", 1, ParameterDescriptor(integer_range=[span]))
    assert node(count=5).declare_parameter("count", 1, ParameterDescriptor(integer_range=[span])).value == 5


def test_what_is_read_only_keeps_what_the_node_started_with(simulation: Simulation) -> None:
    started = node(rate=2.0)
    started.declare_parameters("", [("rate", 1.0, limits(0.5, 10.0, read_only=True))])
    (result,) = started.set_parameters([Parameter("rate", value=3.0)])
    assert not result.successful
    assert "read-only" in result.reason
    assert started.get_parameter("rate").value == 2.0


def test_a_parameter_without_a_value_cannot_be_read(simulation: Simulation) -> None:
    started = node()
    started.declare_parameter("rate", Parameter.Type.DOUBLE)
    with pytest.raises(ParameterUninitializedException, match="'rate' is not initialized"):
        started.get_parameter("rate")
    started.set_parameters([Parameter("rate", value=2.0)])
    assert started.get_parameter("rate").value == 2.0


def test_an_override_of_another_type_is_refused_or_ignored(simulation: Simulation) -> None:
    with pytest.raises(InvalidParameterTypeException):
        node(rate=2).declare_parameter("rate", 1.0)
    assert node(rate=2.0).declare_parameter("rate", 1.0, ignore_override=True).value == 1.0
    assert node(use_sim_time=False).get_parameter("use_sim_time").value is False


def test_topics_are_resolved_as_the_node_calls_them(simulation: Simulation) -> None:
    named = Node("node", namespace="front")
    names = [named.resolve_topic_name(topic) for topic in ("scan", "/scan", "~/scan")]
    assert names == ["/front/scan", "/scan", "/front/node/scan"]


def test_a_parameter_of_dynamic_type_takes_values_of_others_within_their_ranges(simulation: Simulation) -> None:
    from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

    span = IntegerRange(from_value=1, to_value=9)
    started = node(rate=4)
    of_both = limits(0.5, 9.0, dynamic_typing=True, integer_range=[span])
    assert started.declare_parameter("rate", 1.0, of_both).value == 4
    (result,) = started.set_parameters([Parameter("rate", value=10)])
    assert not result.successful
    anything = ParameterDescriptor(dynamic_typing=True)
    assert node(rate="fast").declare_parameter("rate", None, anything).value == "fast"


def test_a_parameter_that_is_not_declared_has_an_alternative(simulation: Simulation) -> None:
    started = node(rate=2.0)
    started.declare_parameter("rate", 1.0)
    assert started.get_parameter_or("rate", Parameter("rate", value=7.0)).value == 2.0
    assert started.get_parameter_or("gain", Parameter("gain", value=7.0)).value == 7.0
    assert started.get_parameter_or("gain").type_ == Parameter.Type.NOT_SET


def test_a_parameter_can_be_forgotten_unless_it_is_read_only(simulation: Simulation) -> None:
    started = node()
    started.declare_parameters("", [("rate", 1.0), ("gain", 1.0, limits(0.5, 10.0, read_only=True))])
    started.undeclare_parameter("rate")
    assert not started.has_parameter("rate")
    with pytest.raises(ParameterNotDeclaredException, match="rate"):
        started.undeclare_parameter("rate")
    with pytest.raises(ParameterImmutableException, match="'gain'"):
        started.undeclare_parameter("gain")
    assert started.declare_parameter("rate", "of another type").value == "of another type"


def refusing_odd_numbers(parameters: list[Parameter]) -> Any:
    from rcl_interfaces.msg import SetParametersResult

    odd = [each.name for each in parameters if each.value % 2]
    return SetParametersResult(successful=not odd, reason=f"odd: {odd}" if odd else "")


def doubled(parameters: list[Parameter]) -> list[Parameter]:
    return [Parameter(each.name, value=each.value * 2) for each in parameters]


def test_callbacks_change_refuse_and_hear_of_values(simulation: Simulation) -> None:
    node, heard = Node("node"), []
    node.declare_parameters("", [("a", 1), ("b", 2)])
    node.add_on_set_parameters_callback(refusing_odd_numbers)
    node.add_pre_set_parameters_callback(doubled)
    node.add_post_set_parameters_callback(lambda done: heard.append([(each.name, each.value) for each in done]))
    assert [each.successful for each in node.set_parameters([Parameter("a", value=3), Parameter("b", value=4)])]
    assert heard == [[("a", 6)], [("b", 8)]]
    node.remove_pre_set_parameters_callback(doubled)
    result = node.set_parameters_atomically([Parameter("a", value=10), Parameter("b", value=11)])
    assert (result.successful, result.reason) == (False, "odd: ['b']")
    assert [each.value for each in node.get_parameters(["a", "b"])] == [6, 8], "all or none"
    with pytest.raises(InvalidParameterValueException, match="odd"):
        node.declare_parameter("c", 5)
    node.remove_on_set_parameters_callback(refusing_odd_numbers)
    assert node.set_parameters([Parameter("a", value=5)])[0].successful


def test_parameters_are_described(simulation: Simulation) -> None:
    from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

    node = Node("node")
    limits = ParameterDescriptor(description="a number", integer_range=[IntegerRange(from_value=0, to_value=9)])
    node.declare_parameter("group.number", 3, limits)
    described = node.describe_parameter("group.number")
    assert (described.name, described.type, described.description) == ("group.number", 2, "a number")
    assert node.describe_parameters(["use_sim_time"])[0].type == 1
    assert node.get_parameter_type("group.number") == Parameter.Type.INTEGER
    assert node.get_parameter_types(["nothing"]) == [Parameter.Type.NOT_SET]
    assert {name: each.value for name, each in node.get_parameters_by_prefix("group").items()} == {"number": 3}
    node.declare_parameter("group.later", Parameter.Type.DOUBLE)
    assert node.get_parameters_by_prefix("group")["later"].type_ == Parameter.Type.NOT_SET, "asking for all is no error"
    with pytest.raises(InvalidParameterValueException):
        node.set_descriptor("group.number", ParameterDescriptor(integer_range=[IntegerRange(from_value=5, to_value=9)]))
    assert node.set_descriptor("group.number", ParameterDescriptor(), 8).integer_value == 8
    with pytest.raises(ParameterNotDeclaredException):
        node.describe_parameter("nothing")


def test_undeclared_parameters_are_allowed_on_request(simulation: Simulation) -> None:
    given = [Parameter("given", value=1)]
    node = Node(
        "node",
        allow_undeclared_parameters=True,
        automatically_declare_parameters_from_overrides=True,
        parameter_overrides=given,
    )
    assert (node.has_parameter("given"), node.has_parameter("other")) == (True, False)
    assert node.get_parameter("other").value is None
    assert node.set_parameters([Parameter("other", value="text"), Parameter("other", value=2)])[1].successful
    assert node.get_parameter("other").value == 2, "undeclared parameters have no type"


def test_parameters_become_messages_and_back() -> None:
    for value in (True, 3, 0.5, "text", [1, 2], [0.5], None):
        parameter = Parameter.from_parameter_msg(Parameter("name", value=value).to_parameter_msg())
        found = (
            parameter.value if value is None or isinstance(value, bool | int | float | str) else list(parameter.value)
        )
        assert (parameter.name, found) == ("name", value)


@pytest.mark.parametrize(
    ("prefixes", "depth", "names", "parents"),
    [
        ([], 1, ["use_sim_time", "a"], []),
        ([], 0, ["use_sim_time", "a", "b.c", "b.d.e", "bc.d"], ["b", "b.d", "bc"]),
        (["b"], 1, ["b.c"], ["b"]),
        (["b"], 0, ["b.c", "b.d.e"], ["b", "b.d"]),
        (["a", "bc"], 2, ["a", "bc.d"], ["bc"]),
    ],
)
def test_parameters_are_listed(
    simulation: Simulation, prefixes: list[str], depth: int, names: list[str], parents: list[str]
) -> None:
    node = Node("node")
    node.declare_parameters("", [(name, 1) for name in ("a", "b.c", "b.d.e", "bc.d")])
    result = node.list_parameters(prefixes, depth)
    assert (list(result.names), list(result.prefixes)) == (names, parents)
