"""Writes the networks of the tests, and places on them as other programs compute them.

Run by hand, since the programs are large and what they say does not change. The networks are written by
scenariogeneration 0.16.7. Lines, arcs, clothoids and the edges of lanes are computed by opendrive2lanelet 1.2.1
(`pip install --no-deps`; its parser needs lxml, numpy and scipy only), clothoids also by pyclothoids 0.2.0. Parametric
curves are measured by scipy 1.17.1, as no other program computes them by arc length.

    python expected_places.py ../resources/networks
"""

import csv
import sys
import types
from copy import deepcopy
from pathlib import Path

import numpy as np
from lxml import etree
from pyclothoids import Clothoid
from scenariogeneration import xodr
from scipy.integrate import quad
from scipy.optimize import brentq

# The converter imports a data model for its output, which is not used here.
for name in ("commonroad", "commonroad.scenario", "commonroad.scenario.lanelet"):
    module = types.ModuleType(name)
    module.Lanelet = module.LaneletType = object
    sys.modules[name] = module

from opendrive2lanelet.converter import OpenDriveConverter  # noqa: E402
from opendrive2lanelet.opendriveparser.parser import parse_opendrive  # noqa: E402


def curves():
    """One road of all plane curves, with lanes that begin, end and change their widths."""
    plan = [
        xodr.Line(60),
        xodr.Spiral(1e-9, 0.02, 40),
        xodr.Arc(0.02, 70),
        xodr.Spiral(0.02, -0.015, 80),
        xodr.Arc(-0.015, 50),
        xodr.Spiral(-0.015, -1e-9, 30),
        xodr.Line(25.5),
    ]
    left = [xodr.LaneDef(130, 180, 1, 2, 2), xodr.LaneDef(310, 340, 2, 1, 2)]
    right = [xodr.LaneDef(60, 120, 2, 3, -1), xodr.LaneDef(200, 300, 3, 2, -3)]
    lanes = xodr.create_lanes_merge_split(
        right, left, sum((60, 40, 70, 80, 50, 30, 25.5)), xodr.std_roadmark_broken(), 3.25
    )
    view = xodr.PlanView(12.5, -30.25, 2.1)
    for each in plan:
        view.add_geometry(each)
    road = xodr.Road(1, view, lanes, name="all curves")
    road.add_type(xodr.RoadType.rural, 0, speed=100, speed_unit="km/h")
    second = xodr.create_road([xodr.Spiral(0.001, 0.05, 55), xodr.Spiral(0.05, 0.2, 15)], 2, 1, 2, lane_width=2.9)
    network = xodr.OpenDrive("curves")
    network.add_road(road)
    network.add_road(second)
    second.planview.set_start_point(-200, 100, 0.3)
    network.adjust_roads_and_lanes()
    return network


def parametric():
    """Roads of parametric curves, by both kinds of parameter."""
    network = xodr.OpenDrive("parametric")
    normalized = xodr.ParamPoly3(0, 60, 5, -8, 0, 0, 30, -14, "normalized")
    road = xodr.create_road(normalized, 3, 1, 1)
    road.planview.set_start_point(5, 7, -2.5)
    network.add_road(road)
    length = 40
    by_length = xodr.ParamPoly3(0, 1, 0, -1e-5, 0, 0, 4e-3, 0, "arcLength", length)
    road = xodr.create_road(by_length, 4, 1, 1)
    road.planview.set_start_point(100, 0, 1)
    network.add_road(road)
    network.adjust_roads_and_lanes()
    return network


def crossing():
    """A crossing of four roads."""
    network = xodr.OpenDrive("crossing")
    arms = [xodr.create_road(xodr.Line(80), i, 1, 1, lane_width=3.5) for i in range(4)]
    junction = xodr.CommonJunctionCreator(100, "crossing", startnum=200)
    for i, arm in enumerate(arms):
        junction.add_incoming_road_circular_geometry(arm, 20, i * np.pi / 2, "successor")
    for i in range(4):
        for j in range(i):
            junction.add_connection(j, i)
    for arm in arms:
        network.add_road(arm)
    network.add_junction_creator(junction)
    network.adjust_roads_and_lanes()
    return network


def leaving():
    """A motorway with an exit, by a direct junction."""
    network = xodr.OpenDrive("exit")
    before = xodr.create_road(xodr.Line(300), 1, 1, [xodr.LaneDef(200, 250, 2, 3, -3)])
    after = xodr.create_road(xodr.Line(200), 2, 1, 2)
    ramp = xodr.create_road([xodr.Spiral(-1e-9, -0.02, 60), xodr.Arc(-0.02, 40)], 3, 0, 1)
    before.add_successor(xodr.ElementType.junction, 50)
    after.add_predecessor(xodr.ElementType.junction, 50)
    ramp.add_predecessor(xodr.ElementType.junction, 50)
    junction = xodr.DirectJunctionCreator(50, "exit")
    junction.add_connection(before, after)
    junction.add_connection(before, ramp, -3, -1)
    for road in (before, after, ramp):
        network.add_road(road)
    network.add_junction_creator(junction)
    network.adjust_roads_and_lanes()
    return network


def places_of_lanes(name, root):
    """Places of reference lines and edges of lanes by opendrive2lanelet."""
    network = parse_opendrive(without_junctions(root))
    for road in network.roads:
        reference = OpenDriveConverter.create_reference_border(road.planView, road.lanes.laneOffsets)
        for s in np.linspace(0, road.length - 1e-6, 37):
            place, heading = road.planView.calc_geometry(s)
            yield name, road.id, s, "", "line", place[0], place[1], heading
        for section in road.lanes.lane_sections:
            for lane in OpenDriveConverter.lane_section_to_parametric_lanes(section, reference):
                # Only right lanes are in the order of s there.
                lane_id = int(lane.id_.split(".")[2])
                for share in (0.03, 0.37, 0.5, 0.81, 0.99):
                    along = share * lane.length
                    at = along if lane_id < 0 else lane.length - along
                    for edge in ("inner", "outer"):
                        yield edge_of(lane, name, road, section, lane_id, at, edge)


def without_junctions(root):
    """A copy without junctions, of which the parser does not know all kinds."""
    copy = deepcopy(root)
    for junction in copy.findall("junction"):
        copy.remove(junction)
    return copy


def edge_of(lane, name, road, section, lane_id, at, edge):
    """An edge of a lane at a distance from the start of its section."""
    parts = sorted(lane.parametric_lanes, key=lambda part: part.border_group.outer_border_offset)
    part = [each for each in parts if each.border_group.outer_border_offset <= at][-1]
    group = part.border_group
    border, offset = (
        (group.inner_border, group.inner_border_offset)
        if edge == "inner"
        else (group.outer_border, group.outer_border_offset)
    )
    place, _ = border.calc(at - group.outer_border_offset + offset)
    return name, road.id, section.sPos + at, lane_id, edge, place[0], place[1], ""


def places_of_clothoids(name, root):
    """Places of clothoids by pyclothoids."""
    for road in root.findall("road"):
        for geometry in road.findall("planView/geometry"):
            spiral = geometry.find("spiral")
            if spiral is not None:
                s, x, y, heading, length = (float(geometry.get(key)) for key in ("s", "x", "y", "hdg", "length"))
                start, end = (float(spiral.get(key)) for key in ("curvStart", "curvEnd"))
                curve = Clothoid.StandardParams(x, y, heading, start, (end - start) / length, length)
                for along in np.linspace(0, length * 0.9999, 11):
                    yield (
                        name,
                        road.get("id"),
                        s + along,
                        "",
                        "line",
                        curve.X(along),
                        curve.Y(along),
                        curve.Theta(along),
                    )


def places_of_parametric(name, root):
    """Places of parametric curves at shares of their own arc length, by scipy."""
    for road in root.findall("road"):
        for geometry in road.findall("planView/geometry"):
            curve = geometry.find("paramPoly3")
            if curve is not None:
                yield from places_of_curve(name, road, geometry, curve)


def places_of_curve(name, road, geometry, curve):
    """Places of one parametric curve."""
    s, x, y, heading, length = (float(geometry.get(key)) for key in ("s", "x", "y", "hdg", "length"))
    u, v = (np.polynomial.Polynomial([float(curve.get(key + axis)) for key in "abcd"]) for axis in "UV")
    end = length if curve.get("pRange") == "arcLength" else 1
    du, dv = u.deriv(), v.deriv()

    def arc(p):
        return quad(lambda q: np.hypot(du(q), dv(q)), 0, p, epsabs=1e-12)[0]

    for share in np.linspace(0, 1, 9):
        target = share * arc(end)
        p = brentq(lambda q, to=target: arc(q) - to, 0, end * 1.001) if share > 0 else 0
        at_x = x + u(p) * np.cos(heading) - v(p) * np.sin(heading)
        at_y = y + u(p) * np.sin(heading) + v(p) * np.cos(heading)
        yield name, road.get("id"), s + share * length, "", "line", at_x, at_y, heading + np.arctan2(dv(p), du(p))


def main(folder):
    """Writes the networks and one table of places."""
    rows = []
    for make in (curves, parametric, crossing, leaving):
        network = make()
        file = folder / f"{make.__name__}.xodr"
        network.write_xml(str(file))
        root = etree.parse(str(file)).getroot()
        root.find("header").set("date", "2026-01-01 00:00:00")
        etree.ElementTree(root).write(str(file), encoding="utf-8", xml_declaration=True)
        if make is parametric:
            rows += places_of_parametric(make.__name__, root)
        else:
            rows += places_of_lanes(make.__name__, root)
            rows += places_of_clothoids(make.__name__, root)
    with (folder / "places.csv").open("w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["network", "road", "s", "lane", "edge", "x", "y", "heading"])
        for row in rows:
            table.writerow([f"{value:.6f}" if isinstance(value, float) else value for value in row])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
