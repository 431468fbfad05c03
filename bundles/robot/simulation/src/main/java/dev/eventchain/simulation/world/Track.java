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

  /**
   * A moment of a track.
   *
   * @param place of the middle
   * @param vx velocity of the middle in the plane, in m/s
   * @param vy likewise
   */
  public record Moment(Road.Place place, double vx, double vy) {}

  private final Road road;
  private final List<Moment> moments = new ArrayList<>();
  private final List<Road.Station> stations = new ArrayList<>();

  /** Creates a track without a place. */
  public Track(Road road) {
    this.road = road;
  }

  /**
   * Sets where it is at a moment, and where it will be at the next one.
   *
   * @param number that of the moment, from 0; at most that of the last known one
   * @param now null if it is not there
   * @param next at the next moment; null likewise
   */
  public void put(int number, Moment now, Moment next) {
    set(number, now);
    set(number + 1, next);
  }

  private void set(int number, Moment moment) {
    boolean known = number > 0 && stations.get(number - 1) != null;
    double near = known ? stations.get(number - 1).along() : 0.0;
    Road.Station station =
        moment == null ? null : road.station(moment.place().x(), moment.place().y(), near);
    if (number < moments.size()) {
      moments.set(number, moment);
      stations.set(number, station);
    } else {
      moments.add(moment);
      stations.add(station);
    }
  }

  @Override
  public Road.Place place(Road on, double seconds) {
    int before = before(seconds);
    Road.Place one = known(before).place();
    Road.Place other = known(before + 1).place();
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
    return Math.max(0, Math.min(moment, moments.size() - 2));
  }

  private static double share(double seconds, int before) {
    return seconds / STEP - before;
  }

  /** Returns a moment, or the nearest one at which it is there. */
  private Moment known(int moment) {
    return moments.get(there(moment));
  }

  private int there(int moment) {
    for (int distance = 0; distance < moments.size(); distance++) {
      if (isThere(moment - distance)) {
        return moment - distance;
      } else if (isThere(moment + distance)) {
        return moment + distance;
      }
    }
    throw new IllegalStateException("it was never there");
  }

  private boolean isThere(int moment) {
    return moment >= 0 && moment < moments.size() && moments.get(moment) != null;
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
    double direction = road.heading(station(seconds).along());
    return vx(seconds) * StrictMath.cos(direction) + vy(seconds) * StrictMath.sin(direction);
  }

  @Override
  public double speedAcross(double seconds) {
    double direction = road.heading(station(seconds).along());
    return vy(seconds) * StrictMath.cos(direction) - vx(seconds) * StrictMath.sin(direction);
  }

  private double vx(double seconds) {
    int before = before(seconds);
    double one = known(before).vx();
    return one + (known(before + 1).vx() - one) * share(seconds, before);
  }

  private double vy(double seconds) {
    int before = before(seconds);
    double one = known(before).vy();
    return one + (known(before + 1).vy() - one) * share(seconds, before);
  }

  @Override
  public boolean restsFrom(double seconds) {
    return StrictMath.hypot(vx(seconds), vy(seconds)) < REST;
  }

  /** Returns the bound of the last known step. */
  @Override
  public double fastest(double reach) {
    Road.Place one = known(moments.size() - 2).place();
    Road.Place other = known(moments.size() - 1).place();
    double turned = StrictMath.IEEEremainder(other.heading() - one.heading(), 2.0 * Math.PI);
    double way = StrictMath.hypot(other.x() - one.x(), other.y() - one.y());
    return (way + Math.abs(turned) * reach) / STEP;
  }

  @Override
  public boolean exists(double seconds) {
    return isThere(before(seconds));
  }
}
