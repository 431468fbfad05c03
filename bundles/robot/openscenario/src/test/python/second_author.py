"""Writes files in OpenSCENARIO XML with scenariogeneration 0.16.7, whose authors are not ours.

Usage, with that package from PyPI installed: `python3 second_author.py ../resources/second-author`.

For each version there is a scenario with the actions and conditions that the package writes for it, and one that takes
its entities, environment, controller, maneuver, trajectory and route from catalogs of version 1.3; for the versions
that have them, deterministic and stochastic distributions. Dates are always the same.
"""

import datetime
import sys
from pathlib import Path

from scenariogeneration import xosc
from second_author_distributions import distributions

DATE = datetime.datetime(2026, 11, 28, 12, 0, 0)


def vehicle(name: str) -> xosc.Vehicle:
    box = xosc.BoundingBox(1.8, 4.4, 1.5, 1.3, 0, 0.75)
    front = xosc.Axle(0.5, 0.6, 1.5, 2.7, 0.3)
    rear = xosc.Axle(0, 0.6, 1.5, 0, 0.3)
    car = xosc.Vehicle(name, xosc.VehicleCategory.car, box, front, rear, 60, 5, 9)
    car.add_property("label", "red")
    return car


def pedestrian(name: str) -> xosc.Pedestrian:
    box = xosc.BoundingBox(0.5, 0.6, 1.8, 0, 0, 0.9)
    return xosc.Pedestrian(name, 80, xosc.PedestrianCategory.pedestrian, box, "walker")


def misc(name: str) -> xosc.MiscObject:
    box = xosc.BoundingBox(1, 2, 3, 0, 0, 1.5)
    return xosc.MiscObject(name, 100, xosc.MiscObjectCategory.obstacle, box)


def environment(name: str, minor: int = 3) -> xosc.Environment:
    clouds = xosc.CloudState.free if minor < 2 else xosc.FractionalCloudCover.oneOktas
    weather = xosc.Weather(
        clouds,
        sun=xosc.Sun(0.5, 1, 0.8),
        fog=xosc.Fog(1000),
        precipitation=xosc.Precipitation(xosc.PrecipitationType.dry, 0),
    )
    noon = xosc.TimeOfDay(False, 2026, 6, 21, 12, 0, 0)
    return xosc.Environment(name, noon, weather, xosc.RoadCondition(0.9))


def controller(name: str) -> xosc.Controller:
    settings = xosc.Properties()
    settings.add_property("mode", "calm")
    return xosc.Controller(name, settings)


def lane(s: float) -> xosc.LanePosition:
    return xosc.LanePosition(s, 0.1, -1, "1")


def route(name: str) -> xosc.Route:
    way = xosc.Route(name)
    way.add_waypoint(lane(0), xosc.RouteStrategy.shortest)
    way.add_waypoint(lane(100), xosc.RouteStrategy.fastest)
    return way


def trajectory(name: str) -> xosc.Trajectory:
    path = xosc.Trajectory(name, False)
    path.add_shape(xosc.Polyline([0, 1, 3], [xosc.WorldPosition(x, 0, 0, 0, 0, 0) for x in (0, 10, 40)]))
    return path


def clothoid(name: str) -> xosc.Trajectory:
    path = xosc.Trajectory(name, False)
    path.add_shape(xosc.Clothoid(0.001, 0.01, 50, xosc.WorldPosition(), 0, 5))
    return path


def nurbs(name: str) -> xosc.Trajectory:
    path = xosc.Trajectory(name, False)
    shape = xosc.Nurbs(3)
    for x in (0, 10, 20):
        shape.add_control_point(xosc.ControlPoint(xosc.WorldPosition(x, x)))
    shape.add_knots([0, 0, 0, 1, 1, 1])
    path.add_shape(shape)
    return path


def step() -> xosc.TransitionDynamics:
    return xosc.TransitionDynamics(xosc.DynamicsShapes.linear, xosc.DynamicsDimension.time, 2)


def following() -> list:
    return [
        xosc.FollowTrajectoryAction(shape, xosc.FollowingMode.position, *times)
        for shape, times in (
            (trajectory("line"), (xosc.ReferenceContext.relative, 1, 0)),
            (clothoid("bend"), ()),
            (nurbs("wave"), ()),
        )
    ]


def assigned(minor: int) -> xosc.AssignControllerAction:
    own = controller("own")
    return xosc.AssignControllerAction(own if minor < 3 else xosc.ObjectController("own", controller=own))


def actions(minor: int) -> list:
    """Returns makers of actions; a version that does not have one lets it raise."""
    target = xosc.RelativeLanePosition(0, "Target", 0.1, 20)
    return [
        lambda: xosc.AbsoluteSpeedAction(10, step()),
        lambda: xosc.RelativeSpeedAction(2, "Target", step()),
        lambda: xosc.LongitudinalDistanceAction("Target", distance=20, max_speed=30, max_acceleration=3),
        lambda: xosc.LongitudinalDistanceAction("Target", timeGap=2, max_deceleration=3),
        lambda: xosc.SpeedProfileAction([5, 10, 0], xosc.FollowingMode.follow, [1, 2, 3]),
        lambda: xosc.AbsoluteLaneChangeAction(-2, step()),
        lambda: xosc.RelativeLaneChangeAction(1, "Target", step(), 0.2),
        lambda: xosc.AbsoluteLaneOffsetAction(0.5, xosc.DynamicsShapes.sinusoidal, 3),
        lambda: xosc.RelativeLaneOffsetAction(0.5, "Target", xosc.DynamicsShapes.step, 3),
        lambda: xosc.LateralDistanceAction("Target", 1.5, max_acceleration=2),
        lambda: xosc.VisibilityAction(True, False, True),
        lambda: xosc.SynchronizeAction("Target", lane(100), lane(80), final_speed=xosc.AbsoluteSpeed(10)),
        lambda: xosc.ActivateControllerAction(True, False),
        lambda: xosc.ControllerAction(assignControllerAction=assigned(minor)),
        lambda: xosc.TeleportAction(target),
        lambda: xosc.AcquirePositionAction(xosc.RelativeObjectPosition("Target", 5, 1)),
        lambda: xosc.AssignRouteAction(route("way")),
        *[lambda action=action: action for action in following()],
        lambda: xosc.AddEntityAction("Target", xosc.RoadPosition(10, 1, reference_id=1)),
        lambda: xosc.DeleteEntityAction("Target"),
        lambda: xosc.EnvironmentAction(environment("day", minor)),
        lambda: xosc.ParameterSetAction("mode", "wild"),
        lambda: xosc.ParameterAddAction("speed", 2),
        lambda: xosc.ParameterMultiplyAction("speed", 2),
        lambda: xosc.VariableSetAction("seen", True),
        lambda: xosc.VariableAddAction("times", 1),
        lambda: xosc.VariableMultiplyAction("times", 2),
        lambda: xosc.TrafficSignalStateAction("light", "green"),
        lambda: xosc.RandomRouteAction(),
        lambda: xosc.UserDefinedAction(xosc.CustomCommandAction("beep", "loud")),
    ]


def conditions() -> list:
    """Returns makers of conditions, likewise."""
    greater = xosc.Rule.greaterThan
    return [
        lambda: xosc.EndOfRoadCondition(1),
        lambda: xosc.CollisionCondition("Target"),
        lambda: xosc.OffroadCondition(1),
        lambda: xosc.TimeHeadwayCondition("Target", 2, greater),
        lambda: xosc.TimeToCollisionCondition(2, greater, entity="Target"),
        lambda: xosc.TimeToCollisionCondition(2, greater, position=lane(50)),
        lambda: xosc.AccelerationCondition(2, greater),
        lambda: xosc.StandStillCondition(1),
        lambda: xosc.SpeedCondition("$speed", greater),
        lambda: xosc.RelativeSpeedCondition(2, greater, "Target"),
        lambda: xosc.TraveledDistanceCondition(20),
        lambda: xosc.ReachPositionCondition(lane(30), 1),
        lambda: xosc.DistanceCondition(10, greater, lane(30)),
        lambda: xosc.RelativeDistanceCondition(10, greater, xosc.RelativeDistanceType.longitudinal, "Target"),
        lambda: xosc.RelativeClearanceCondition(True),
        lambda: xosc.AngleCondition(0.1, 0.2, xosc.AngleType.heading, xosc.CoordinateSystem.road),
        lambda: xosc.RelativeAngleCondition(0.1, 0.2, xosc.AngleType.heading, "Target", xosc.CoordinateSystem.road),
        lambda: xosc.ParameterCondition("speed", 2, greater),
        lambda: xosc.VariableCondition("times", 2, greater),
        lambda: xosc.TimeOfDayCondition(greater, 2026, 6, 21, 12, 0, 0),
        lambda: xosc.SimulationTimeCondition(5, greater),
        lambda: xosc.StoryboardElementStateCondition(
            xosc.StoryboardElementType.event, "first", xosc.StoryboardElementState.completeState
        ),
        lambda: xosc.UserDefinedValueCondition("weather", "mild", xosc.Rule.equalTo),
        lambda: xosc.TrafficSignalCondition("light", "green"),
    ]


def written(maker):
    """Returns what a maker makes, or None if the version does not have it."""
    try:
        made = maker()
        made.get_element()
    except (xosc.OpenSCENARIOVersionError, xosc.NotEnoughInputArguments):
        return None
    return made


def trigger(condition, number: int):
    if isinstance(condition, xosc.triggers._EntityTriggerType):
        return xosc.EntityTrigger(f"condition {number}", 0.1, xosc.ConditionEdge.rising, condition, "Ego")
    return xosc.ValueTrigger(f"condition {number}", 0, xosc.ConditionEdge.none, condition)


def storyboard(minor: int) -> xosc.StoryBoard:
    xosc.VersionBase().setVersion(minor=minor)
    triggers = [each for each in (written(maker) for maker in conditions()) if each]
    maneuver = xosc.Maneuver("all")
    for number, action in enumerate(written(maker) for maker in actions(minor)):
        if action:
            event = xosc.Event(f"event {number}", xosc.Priority.parallel)
            event.add_action(f"action {number}", action)
            event.add_trigger(trigger(triggers[number % len(triggers)], number))
            maneuver.add_event(event)
    group = xosc.ManeuverGroup("group")
    group.add_actor("Ego")
    group.add_maneuver(maneuver)
    act = xosc.Act("act", xosc.ValueTrigger("begin", 0, xosc.ConditionEdge.none, triggers[-1]))
    act.add_maneuver_group(group)
    story = xosc.Story("story")
    story.add_act(act)
    init = xosc.Init()
    init.add_init_action("Ego", xosc.TeleportAction(lane(10)))
    init.add_init_action("Ego", xosc.AbsoluteSpeedAction("${$speed / 3.6}" if minor else "$speed", step()))
    board = xosc.StoryBoard(init, xosc.ValueTrigger("end", 0, xosc.ConditionEdge.none, triggers[-1], "stop"))
    board.add_story(story)
    return board


def parameters(minor: int) -> xosc.ParameterDeclarations:
    declared = xosc.ParameterDeclarations()
    speed = xosc.Parameter("speed", xosc.ParameterType.double, "36")
    if minor:
        group = xosc.ValueConstraintGroup()
        group.add_value_constraint(xosc.ValueConstraint(xosc.Rule.greaterThan, "0"))
        speed.add_value_constraint_group(group)
    declared.add_parameter(speed)
    declared.add_parameter(xosc.Parameter("mode", xosc.ParameterType.string, "calm"))
    return declared


def variables(minor: int) -> xosc.VariableDeclarations | None:
    if minor < 2:
        return None
    declared = xosc.VariableDeclarations()
    declared.add_variable(xosc.Variable("seen", xosc.ParameterType.boolean, "false"))
    declared.add_variable(xosc.Variable("times", xosc.ParameterType.double, "1"))
    return declared


def scenario(minor: int, entities: xosc.Entities, board: xosc.StoryBoard, catalogs: xosc.Catalog) -> xosc.Scenario:
    return xosc.Scenario(
        "everything",
        "Eventchain",
        parameters(minor),
        entities,
        board,
        xosc.RoadNetwork(),
        catalogs,
        osc_minor_version=minor,
        creation_date=DATE,
        variable_declaration=variables(minor),
    )


def everything(minor: int) -> xosc.Scenario:
    entities = xosc.Entities()
    entities.add_scenario_object("Ego", vehicle("ego"), controller("driver"))
    entities.add_scenario_object("Target", vehicle("target"))
    entities.add_scenario_object("Walker", pedestrian("walker"))
    entities.add_scenario_object("Box", misc("box"))
    return scenario(minor, entities, storyboard(minor), xosc.Catalog())


KINDS = {
    "VehicleCatalog": vehicle,
    "PedestrianCatalog": pedestrian,
    "MiscObjectCatalog": misc,
    "EnvironmentCatalog": environment,
    "ControllerCatalog": controller,
    "TrajectoryCatalog": trajectory,
    "RouteCatalog": route,
    "ManeuverCatalog": None,
}


def maneuver() -> xosc.Maneuver:
    declared = xosc.ParameterDeclarations()
    declared.add_parameter(xosc.Parameter("goal", xosc.ParameterType.double, "1"))
    made = xosc.Maneuver("entry", declared)
    event = xosc.Event("first", xosc.Priority.override)
    event.add_action("go", xosc.AbsoluteSpeedAction("$goal", step()))
    event.add_trigger(trigger(xosc.SimulationTimeCondition(1, xosc.Rule.greaterThan), 0))
    made.add_event(event)
    return made


def catalogs(folder: Path) -> None:
    for kind, maker in KINDS.items():
        place = folder / "catalogs" / kind
        place.mkdir(parents=True, exist_ok=True)
        file = xosc.CatalogFile()
        file.create_catalog(str(place / f"{kind}.xosc"), kind, "A catalog", "Eventchain", creation_date=DATE)
        file.add_to_catalog(maker("entry") if maker else maneuver())
        file.dump()


def referring(minor: int) -> xosc.Scenario:
    locations = xosc.Catalog()
    for kind in KINDS:
        locations.add_catalog(kind, f"../catalogs/{kind}")
    entities = xosc.Entities()
    entities.add_scenario_object(
        "Ego",
        xosc.CatalogReference("VehicleCatalog", "entry"),
        xosc.CatalogReference("ControllerCatalog", "entry"),
    )
    entities.add_scenario_object("Target", xosc.CatalogReference("PedestrianCatalog", "entry"))
    entities.add_scenario_object("Box", xosc.CatalogReference("MiscObjectCatalog", "entry"))
    init = xosc.Init()
    init.add_global_action(xosc.EnvironmentAction(xosc.CatalogReference("EnvironmentCatalog", "entry")))
    init.add_init_action("Ego", xosc.AssignRouteAction(xosc.CatalogReference("RouteCatalog", "entry")))
    follow = xosc.FollowTrajectoryAction(
        xosc.CatalogReference("TrajectoryCatalog", "entry"), xosc.FollowingMode.position
    )
    init.add_init_action("Target", follow)
    assigned = xosc.CatalogReference("ManeuverCatalog", "entry")
    assigned.add_parameter_assignment("goal", "$speed")
    group = xosc.ManeuverGroup("group")
    group.add_actor("Ego")
    group.add_maneuver(assigned)
    later = xosc.SimulationTimeCondition(1, xosc.Rule.greaterThan)
    begin = xosc.ValueTrigger("begin", 0, xosc.ConditionEdge.none, later)
    act = xosc.Act("act", begin)
    act.add_maneuver_group(group)
    story = xosc.Story("story")
    story.add_act(act)
    end = xosc.ValueTrigger("end", 0, xosc.ConditionEdge.none, later, "stop")
    board = xosc.StoryBoard(init, end)
    board.add_story(story)
    return scenario(minor, entities, board, locations)


def main() -> None:
    catalogs(Path(sys.argv[1]))
    for minor in range(4):
        folder = Path(sys.argv[1]) / f"1.{minor}"
        folder.mkdir(parents=True, exist_ok=True)
        everything(minor).write_xml(str(folder / "everything.xosc"))
        referring(minor).write_xml(str(folder / "referring.xosc"))
        if minor > 0:
            distributions(folder, minor, DATE)


if __name__ == "__main__":
    main()
