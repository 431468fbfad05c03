package dev.eventchain.roads.link;

import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;

/**
 * An end of a lane within its section.
 *
 * @param section the index of the lane section
 * @param atEnd whether it is where the section ends, or else where it starts
 */
public record LaneEnd(Road road, int section, int lane, boolean atEnd) {

  /** Returns whether another end is that at which the next section of the same road begins. */
  public boolean goesOnAt(LaneEnd entry) {
    return entry.road() == road && entry.section() == section + (atEnd ? 1 : -1);
  }

  /** Returns the other end of the lane. */
  public LaneEnd other() {
    return new LaneEnd(road, section, lane, !atEnd);
  }

  // Those of records are linked when they first run, which a map of many lanes pays for.

  @Override
  public boolean equals(Object other) {
    return other instanceof LaneEnd end
        && road == end.road
        && section == end.section
        && lane == end.lane
        && atEnd == end.atEnd;
  }

  @Override
  public int hashCode() {
    return ((road.hashCode() * 31 + section) * 31 + lane) * 2 + (atEnd ? 1 : 0);
  }

  /** Returns the section that the lane belongs to. */
  public LaneSection laneSection() {
    return road.sections().get(section);
  }

  /** Returns the pose of the lane's middle. */
  public Pose pose() {
    return road.pose(s(), laneSection().centre(lane, s()));
  }

  /** Returns the lane for messages. */
  @Override
  public String toString() {
    return lane + " of road `" + road.id() + "`";
  }

  /** Returns s. */
  public double s() {
    return atEnd ? laneSection().end() : laneSection().start();
  }
}
