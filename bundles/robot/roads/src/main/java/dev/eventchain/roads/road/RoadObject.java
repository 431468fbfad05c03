package dev.eventchain.roads.road;

import java.util.List;
import java.util.Optional;

/**
 * An object beside or on a road, such as a pole, a barrier or a building.
 *
 * @param id the id
 * @param type as in OpenDRIVE, such as {@code pole}; empty if the file does not say
 * @param subtype as in OpenDRIVE; often empty
 * @param name often empty
 * @param dynamic whether it moves
 * @param bodies its bodies in the inertial frame: one, or those of its repetitions
 */
public record RoadObject(
    String id, String type, String subtype, String name, boolean dynamic, List<Body> bodies) {

  /**
   * A body in the inertial frame.
   *
   * @param pose of the middle of the bottom
   * @param length along the heading, in m; 0 if the file does not say
   * @param width across the heading, in m; 0 if the file does not say
   * @param height in m; 0 if the file does not say
   * @param radius of an upright cylinder, in m; empty for a box
   * @param outlines prisms that it consists of; empty for a box or cylinder
   */
  public record Body(
      Pose pose,
      double length,
      double width,
      double height,
      Optional<Double> radius,
      List<Outline> outlines) {

    /** Copies the outlines. */
    public Body {
      outlines = List.copyOf(outlines);
    }
  }

  /**
   * An outline on the ground with the height above each corner.
   *
   * @param closed whether it is an area and no line
   * @param corners in order
   */
  public record Outline(boolean closed, List<Corner> corners) {

    /** Copies the corners. */
    public Outline {
      corners = List.copyOf(corners);
    }
  }

  /**
   * A corner of an outline in the inertial frame.
   *
   * @param x in m
   * @param y in m
   * @param z of the bottom, in m
   * @param height of the top above the bottom, in m
   */
  public record Corner(double x, double y, double z, double height) {}

  /** Copies the bodies. */
  public RoadObject {
    bodies = List.copyOf(bodies);
  }
}
