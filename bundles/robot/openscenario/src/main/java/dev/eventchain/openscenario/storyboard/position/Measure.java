package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Footprint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.DoubleSummaryStatistics;
import java.util.OptionalDouble;

/**
 * Way in which a distance is measured.
 *
 * @param kind along which dimension
 * @param frame in whose coordinates
 * @param freespace between what the bodies cover, and not between their reference points
 */
public record Measure(Kind kind, Frame frame, boolean freespace) {

  /** Time over which the change of a distance is looked at, in s. */
  private static final double MOMENT = 1e-4;

  /** Dimensions of a distance. */
  public enum Kind {
    LONGITUDINAL,
    LATERAL,
    EUCLIDEAN
  }

  /** Coordinates in which a distance is measured. */
  public enum Frame {
    ENTITY,
    WORLD,
    ROAD
  }

  /** Reads that of a condition. */
  public static Measure of(ScenarioElement condition) {
    Kind kind =
        switch (condition.optional("relativeDistanceType").orElse("")) {
          case "longitudinal" -> Kind.LONGITUDINAL;
          case "lateral" -> Kind.LATERAL;
          default -> Kind.EUCLIDEAN;
        };
    if (condition.flag("alongRoute", false)) {
      return new Measure(Kind.LONGITUDINAL, Frame.ROAD, condition.flag("freespace"));
    }
    return new Measure(kind, frame(condition), condition.flag("freespace"));
  }

  /** Reads the coordinate system of a condition or an action; lanes go along their roads. */
  public static Frame frame(ScenarioElement element) {
    return switch (element.optional("coordinateSystem").orElse("entity")) {
      case "lane", "road" -> Frame.ROAD;
      case "world" -> Frame.WORLD;
      default -> Frame.ENTITY;
    };
  }

  /**
   * Returns a distance, which is not negative.
   *
   * @param from whose coordinates those of an entity are
   * @return empty if there is no way from one to the other in these coordinates
   */
  public OptionalDouble distance(Scene scene, Body from, Body to) {
    if (kind == Kind.EUCLIDEAN) {
      double distance =
          freespace
              ? from.footprint(true).distance(to.footprint(true))
              : from.pose().distance(to.pose());
      return OptionalDouble.of(distance);
    }
    OptionalDouble gap = signed(scene, from, to);
    return gap.isPresent() ? OptionalDouble.of(Math.abs(gap.getAsDouble())) : gap;
  }

  /**
   * Returns how far the second is ahead of the first, or to its left; negative behind it, or to its
   * right; 0 between bodies that are beside or behind each other.
   */
  public OptionalDouble signed(Scene scene, Body from, Body to) {
    if (frame == Frame.ROAD) {
      return onRoad(scene, from, to);
    }
    Pose axes = frame == Frame.WORLD ? from.pose().withHeading(0) : from.pose();
    return OptionalDouble.of(gap(range(axes, from), range(axes, to)));
  }

  /**
   * Returns the gap in front of the first body, or behind it; negative where they overlap.
   *
   * @param trailing whether the first one is to be behind the second
   */
  public OptionalDouble gap(Scene scene, Body from, Body to, boolean trailing) {
    Pose axes = frame == Frame.WORLD ? from.pose().withHeading(0) : from.pose();
    double forward = 1;
    double apart = 0;
    DoubleSummaryStatistics other = range(axes, to);
    if (frame == Frame.ROAD && from.road().isPresent() && to.road().isPresent()) {
      RoadPoint first = scene.roads().road(from.road().get());
      RoadPoint second = scene.roads().road(to.road().get());
      OptionalDouble along = scene.roads().along(first, second);
      if (along.isEmpty()) {
        return along;
      }
      axes = scene.roads().pose(first);
      forward = isAlongS(axes, from) ? 1 : -1;
      apart = along.getAsDouble();
      other = range(scene.roads().pose(second), to);
    }
    DoubleSummaryStatistics own = range(axes, from);
    return OptionalDouble.of(
        trailing == (forward > 0)
            ? other.getMin() + apart - own.getMax()
            : own.getMin() - other.getMax() - apart);
  }

  private OptionalDouble onRoad(Scene scene, Body from, Body to) {
    if (from.road().isEmpty() || to.road().isEmpty()) {
      return OptionalDouble.empty();
    }
    RoadPoint first = scene.roads().road(from.road().get());
    RoadPoint second = scene.roads().road(to.road().get());
    OptionalDouble along = scene.roads().along(first, second);
    if (along.isEmpty()) {
      return along;
    }
    Pose firstAxes = scene.roads().pose(first);
    Pose secondAxes = scene.roads().pose(second);
    double apart = kind == Kind.LONGITUDINAL ? along.getAsDouble() : second.t() - first.t();
    DoubleSummaryStatistics ahead = range(secondAxes, to);
    double gap = gap(range(firstAxes, from), ahead.getMin() + apart, ahead.getMax() + apart);
    return OptionalDouble.of(isAlongS(firstAxes, from) ? gap : -gap);
  }

  private static boolean isAlongS(Pose axes, Body body) {
    return StrictMath.cos(body.pose().heading() - axes.heading()) >= 0;
  }

  private DoubleSummaryStatistics range(Pose axes, Body body) {
    Footprint covered = body.footprint(freespace);
    return (kind == Kind.LONGITUDINAL ? covered.ahead(axes) : covered.left(axes))
        .summaryStatistics();
  }

  private static double gap(DoubleSummaryStatistics first, DoubleSummaryStatistics second) {
    return gap(first, second.getMin(), second.getMax());
  }

  private static double gap(DoubleSummaryStatistics first, double min, double max) {
    if (min > first.getMax()) {
      return min - first.getMax();
    }
    return max < first.getMin() ? max - first.getMin() : 0;
  }

  /** Returns by how much a distance gets smaller per second while both keep their velocities. */
  public OptionalDouble closing(Scene scene, Body from, Body to) {
    OptionalDouble now = distance(scene, from, to);
    OptionalDouble then = distance(scene, from.after(scene, MOMENT), to.after(scene, MOMENT));
    return now.isPresent() && then.isPresent()
        ? OptionalDouble.of((now.getAsDouble() - then.getAsDouble()) / MOMENT)
        : OptionalDouble.empty();
  }
}
