package dev.eventchain.roads.road;

import java.util.List;

/**
 * The marking of a lane's outer edge.
 *
 * @param start s where it begins, in m; it ends where the next one of the lane begins
 * @param type as in OpenDRIVE, such as {@code solid}, {@code broken} or {@code none}
 * @param color as in OpenDRIVE, such as {@code standard}
 * @param weight as in OpenDRIVE, {@code standard} or {@code bold}
 * @param width in m; 0 if the file does not say
 * @param laneChange as in OpenDRIVE: {@code increase}, {@code decrease}, {@code both}, {@code none}
 * @param lines the lines that it consists of; empty if the file only names its type
 */
public record RoadMark(
    double start,
    String type,
    String color,
    String weight,
    double width,
    String laneChange,
    List<Line> lines) {

  /**
   * A line of a marking.
   *
   * @param length of a dash, in m; 0 for a line without gaps
   * @param space between dashes, in m
   * @param tOffset to the lane's outer edge, in m
   * @param sOffset of the first dash to the marking's start, in m
   * @param width in m
   */
  public record Line(double length, double space, double tOffset, double sOffset, double width) {}

  /** Copies the lines. */
  public RoadMark {
    lines = List.copyOf(lines);
  }
}
