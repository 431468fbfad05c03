package dev.eventchain.roads.reader;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about road networks. */
final class RoadRules {

  static final Rule DUPLICATE = Rule.error("road.duplicate");
  static final Rule EMPTY = Rule.error("road.empty");
  static final Rule GAP = Rule.error("road.gap");
  static final Rule LANE_ID = Rule.error("road.lane.id");
  static final Rule LANE_WIDTH = Rule.error("road.lane.width");
  static final Rule LANE_WIDTH_NEGATIVE = Rule.warning("road.lane.width.negative");
  static final Rule LENGTH = Rule.error("road.length");
  static final Rule LENGTH_UNEQUAL = Rule.warning("road.length.unequal");
  static final Rule LINK = Rule.error("road.link");
  static final Rule LINK_APART = Rule.warning("road.link.apart");
  static final Rule ORDER = Rule.error("road.order");
  static final Rule VERSION = Rule.error("road.version");
  static final Rule VERSION_OLD = Rule.warning("road.version.old");

  private RoadRules() {}
}
