package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.RoadMark;
import dev.eventchain.simulation.world.Road;
import java.util.ArrayList;
import java.util.List;

/** The marks and borders of a map's lanes near a part of the ego's lane. */
final class LaneLines {

  /** Distance between two places of a line before those on a straight part are left out, in m. */
  private static final double STEP = 2.0;

  /** Distance between places at which a road is looked at first, in m. */
  private static final double COARSE = 40.0;

  /** Distance from the ego's lane up to which a line matters, in m: more than a picture shows. */
  private static final double ASIDE = 60.0;

  /** Difference of direction from which on a place is kept, in rad. */
  private static final double TURNED = 0.002;

  private final EgoLane lane;
  private final double from;
  private final double to;
  private final List<Road.Line> lines = new ArrayList<>();

  private LaneLines(EgoLane lane, double from, double to) {
    this.lane = lane;
    this.from = from;
    this.to = to;
  }

  static List<Road.Line> of(RoadNetwork network, EgoLane lane, double from, double to) {
    LaneLines lines = new LaneLines(lane, from, to);
    network.roads().stream().filter(lines::isNear).forEach(lines::add);
    return lines.lines;
  }

  /** Returns whether a road comes near, at places so far apart that none is missed. */
  private boolean isNear(dev.eventchain.roads.road.Road road) {
    for (double s = 0.0; s < road.length() + COARSE; s += COARSE) {
      Road.Place place = place(road.pose(Math.min(s, road.length()), 0.0));
      if (isNear(place, ASIDE + COARSE)) {
        return true;
      }
    }
    return false;
  }

  private void add(dev.eventchain.roads.road.Road road) {
    for (LaneSection section : road.sections()) {
      int outermost = section.lanes().get(0).id();
      int innermost = section.lanes().get(section.lanes().size() - 1).id();
      for (Lane each : section.lanes()) {
        boolean border = each.id() == outermost || each.id() == innermost;
        List<RoadMark> marks =
            each.marks().stream().filter(mark -> !mark.type().equals("none")).toList();
        if (border || !marks.isEmpty()) {
          boolean broken = !marks.isEmpty() && marks.get(0).type().equals("broken");
          add(road, section, each.id(), broken);
        }
      }
    }
  }

  /** Adds the parts of a lane's outer edge that are near. */
  private void add(
      dev.eventchain.roads.road.Road road, LaneSection section, int lane, boolean broken) {
    List<Road.Place> places = new ArrayList<>();
    int steps = (int) Math.ceil((section.end() - section.start()) / STEP);
    for (int i = 0; i <= steps; i++) {
      double s = Math.min(section.end(), section.start() + i * STEP);
      double t = lane == 0 ? section.centre(0, s) : section.outerEdge(lane, s);
      Road.Place place = place(road.pose(s, t));
      if (isNear(place, ASIDE)) {
        places.add(place);
      } else {
        finish(places, broken);
      }
    }
    finish(places, broken);
  }

  private Road.Place place(dev.eventchain.roads.road.Pose pose) {
    return lane.frame().toWorld(Pose.flat(pose.x(), pose.y(), pose.heading()));
  }

  private boolean isNear(Road.Place place, double reach) {
    Road.Station station = lane.station(place.x(), place.y(), Double.NaN);
    return station.along() >= from - reach
        && station.along() <= to + reach
        && Math.abs(station.across()) <= reach;
  }

  /** Keeps a line, without the places between which it is straight. */
  private void finish(List<Road.Place> places, boolean broken) {
    if (places.size() > 1) {
      List<Road.Place> kept = new ArrayList<>(List.of(places.get(0)));
      for (int i = 1; i < places.size() - 1; i++) {
        double turned = places.get(i).heading() - kept.get(kept.size() - 1).heading();
        if (Math.abs(StrictMath.IEEEremainder(turned, 2.0 * Math.PI)) > TURNED) {
          kept.add(places.get(i));
        }
      }
      kept.add(places.get(places.size() - 1));
      lines.add(new Road.Line(broken, kept));
    }
    places.clear();
  }
}
