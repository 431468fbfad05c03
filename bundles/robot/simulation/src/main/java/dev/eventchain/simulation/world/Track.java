package dev.eventchain.simulation.world;

import java.util.ArrayList;
import java.util.List;

/**
 * The course of an actor that something else moves, as a growing list of places at the moments of
 * the trace, straight between them. Its last place is that of the next moment, if nothing begins
 * until then.
 */
public final class Track implements Course {

  private static final double STEP = World.seconds(World.TRACE_STEP);

  /** Speed below which something that a step moves counts as at rest, in m/s. */
  private static final double REST = 1e-6;

  private final Road road;
  private final List<Road.Place> places = new ArrayList<>();
  private final List<Road.Station> stations = new ArrayList<>();

  /** Creates a track without a place. */
  public Track(Road road) {
    this.road = road;
  }

  /**
   * Sets where it is at a moment, and where it will be at the next one.
   *
   * @param moment number of the moment, from 0; at most that of the last known one
   * @param now the place; null if it is not there
   * @param next the place at the next moment; null likewise
   */
  public void put(int moment, Road.Place now, Road.Place next) {
    set(moment, now);
    set(moment + 1, next);
  }

  private void set(int moment, Road.Place place) {
    double near =
        moment > 0 && stations.get(moment - 1) != null ? stations.get(moment - 1).along() : 0.0;
    Road.Station station = place == null ? null : road.station(place.x(), place.y(), near);
    if (moment < places.size()) {
      places.set(moment, place);
      stations.set(moment, station);
    } else {
      places.add(place);
      stations.add(station);
    }
  }

  @Override
  public Road.Place place(Road on, double seconds) {
    int before = before(seconds);
    Road.Place one = known(before);
    Road.Place other = known(before + 1);
    double share = share(seconds, before);
    double turned = StrictMath.IEEEremainder(other.heading() - one.heading(), 2.0 * Math.PI);
    return new Road.Place(
        one.x() + (other.x() - one.x()) * share,
        one.y() + (other.y() - one.y()) * share,
        one.heading() + turned * share);
  }

  /** Returns the last moment that is not after a time and has a next one. */
  private int before(double seconds) {
    int moment = (int) Math.floor(seconds / STEP + 1e-9);
    return Math.max(0, Math.min(moment, places.size() - 2));
  }

  private static double share(double seconds, int before) {
    return seconds / STEP - before;
  }

  /** Returns a place, or that of the nearest moment at which it is there. */
  private Road.Place known(int moment) {
    return places.get(there(moment));
  }

  private int there(int moment) {
    for (int distance = 0; distance < places.size(); distance++) {
      if (isThere(moment - distance)) {
        return moment - distance;
      } else if (isThere(moment + distance)) {
        return moment + distance;
      }
    }
    throw new IllegalStateException("it was never there");
  }

  private boolean isThere(int moment) {
    return moment >= 0 && moment < places.size() && places.get(moment) != null;
  }

  @Override
  public Road.Station station(double seconds) {
    int before = before(seconds);
    Road.Station one = stations.get(there(before));
    Road.Station other = stations.get(there(before + 1));
    double share = share(seconds, before);
    return new Road.Station(
        one.along() + (other.along() - one.along()) * share,
        one.across() + (other.across() - one.across()) * share);
  }

  @Override
  public double heading(double seconds) {
    double relative = place(road, seconds).heading() - road.heading(station(seconds).along());
    return StrictMath.IEEEremainder(relative, 2.0 * Math.PI);
  }

  @Override
  public double speedAlong(double seconds) {
    Road.Place velocity = velocity(seconds);
    double direction = road.heading(station(seconds).along());
    return velocity.x() * StrictMath.cos(direction) + velocity.y() * StrictMath.sin(direction);
  }

  @Override
  public double speedAcross(double seconds) {
    Road.Place velocity = velocity(seconds);
    double direction = road.heading(station(seconds).along());
    return velocity.y() * StrictMath.cos(direction) - velocity.x() * StrictMath.sin(direction);
  }

  /** Returns the velocity in the plane, and the yaw rate. */
  private Road.Place velocity(double seconds) {
    int before = before(seconds);
    Road.Place one = known(before);
    Road.Place other = known(before + 1);
    double turned = StrictMath.IEEEremainder(other.heading() - one.heading(), 2.0 * Math.PI);
    return new Road.Place(
        (other.x() - one.x()) / STEP, (other.y() - one.y()) / STEP, turned / STEP);
  }

  @Override
  public boolean restsFrom(double seconds) {
    Road.Place velocity = velocity(seconds);
    return StrictMath.hypot(velocity.x(), velocity.y()) < REST;
  }

  /** Returns the bound of the last known step. */
  @Override
  public double fastest(double reach) {
    Road.Place velocity = velocity((places.size() - 2) * STEP);
    return StrictMath.hypot(velocity.x(), velocity.y()) + Math.abs(velocity.heading()) * reach;
  }

  @Override
  public boolean exists(double seconds) {
    return isThere(before(seconds));
  }
}
