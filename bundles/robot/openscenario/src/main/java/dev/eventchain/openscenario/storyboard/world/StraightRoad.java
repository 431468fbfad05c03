package dev.eventchain.openscenario.storyboard.world;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * One straight road along the x axis from the origin, traffic on the right; without lanes, a plane
 * that has no road anywhere.
 *
 * @param id its name
 * @param length in m
 * @param left the number of lanes to the left of the x axis
 * @param right the number of lanes to the right of it
 * @param width of each lane, in m
 */
public record StraightRoad(String id, double length, int left, int right, double width)
    implements RoadMap {

  @Override
  public boolean hasRoad(String road) {
    return id.equals(road);
  }

  @Override
  public double length(String road) {
    return length;
  }

  @Override
  public List<Integer> lanes(String road, double s) {
    return Stream.concat(
            IntStream.rangeClosed(1, left).map(each -> left + 1 - each).boxed(),
            IntStream.rangeClosed(1, right).map(each -> -each).boxed())
        .toList();
  }

  @Override
  public double centre(String road, double s, int lane) {
    return lane > 0 ? (lane - 0.5) * width : (lane + 0.5) * width;
  }

  @Override
  public boolean goesAlongS(String road, double s, int lane) {
    return lane < 0;
  }

  @Override
  public Pose pose(RoadPoint point) {
    return Pose.flat(point.s(), point.t(), 0);
  }

  @Override
  public Optional<LanePoint> find(Pose place) {
    boolean inside =
        left + right > 0
            && place.x() >= 0
            && place.x() <= length
            && place.y() <= left * width
            && place.y() >= -right * width;
    return inside ? Optional.of(lane(new RoadPoint(id, place.x(), place.y()))) : Optional.empty();
  }

  @Override
  public Optional<Moved> move(
      LanePoint from, boolean alongS, double distance, List<RoadPoint> route) {
    double s = from.s() + (alongS ? distance : -distance);
    return s < 0 || s > length
        ? Optional.empty()
        : Optional.of(new Moved(new LanePoint(id, from.lane(), s, from.offset()), alongS));
  }

  @Override
  public List<Stretch> way(List<LanePoint> waypoints) {
    boolean alongS = waypoints.get(0).lane() < 0;
    for (int i = 1; i < waypoints.size(); i++) {
      double ahead = waypoints.get(i).s() - waypoints.get(i - 1).s();
      if (waypoints.get(i).lane() < 0 != alongS || ahead < 0 == alongS) {
        return List.of();
      }
    }
    double end = waypoints.get(waypoints.size() - 1).s();
    return List.of(new Stretch(id, alongS, waypoints.get(0).s(), end));
  }

  @Override
  public OptionalDouble along(RoadPoint from, RoadPoint to) {
    return OptionalDouble.of(to.s() - from.s());
  }
}
