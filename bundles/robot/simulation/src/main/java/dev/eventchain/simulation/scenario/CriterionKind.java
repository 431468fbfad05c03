package dev.eventchain.simulation.scenario;

/** Kinds of criteria, by their keys in the scenario's section {@code accept}. */
public enum CriterionKind {
  /** The ego hits nothing. */
  NO_IMPACT("no_impact", 0),
  /** The ego is stationary when the scenario ends. */
  STOPS("stops", 0),
  /** The gap to a vehicle in the own lane never falls below a limit. */
  MINIMAL_GAP("minimal_gap_m", 1),
  /** An impact, if there is one, is not faster than a limit (relative speed, as in UN R152). */
  MAXIMAL_IMPACT_SPEED("maximal_impact_speed_kmh", 1 / 3.6),
  /** There is no brake command above zero. */
  NEVER_BRAKES("never_brakes", 0),
  /** No brake command while the time to collision is at or above a limit. */
  NO_BRAKE_AT_TTC("no_brake_at_ttc_s", 1),
  /** A brake command while the time to collision is below a limit. */
  BRAKE_BELOW_TTC("brake_below_ttc_s", 1),
  /** Less than full brake while the time to collision is at or above a limit. */
  NO_FULL_BRAKE_AT_TTC("no_full_brake_at_ttc_s", 1),
  /** A full brake command while the time to collision is below a limit. */
  FULL_BRAKE_BELOW_TTC("full_brake_below_ttc_s", 1),
  /** Always: each brake command is between 0 and 1. */
  BRAKE_NORMALIZED("brake_normalized", -1),
  /** Always: commands keep coming, so that a dead chain passes no criterion. */
  COMMANDS_ARRIVE("commands_arrive", -1);

  private final String key;
  private final double unit;

  CriterionKind(String key, double unit) {
    this.key = key;
    this.unit = unit;
  }

  String key() {
    return key;
  }

  /** Returns the factor from the unit of the key's number to SI units. */
  double unit() {
    return unit;
  }

  /** Returns whether the key has a number rather than {@code true}. */
  boolean hasLimit() {
    return unit > 0;
  }

  /** Returns whether its limit is a time to collision. */
  boolean comparesTimeToCollision() {
    return key.endsWith("_ttc_s");
  }

  /** Returns whether it is about how the ego moves, however it is commanded. */
  public boolean isOfMotion() {
    return this == NO_IMPACT
        || this == STOPS
        || this == MINIMAL_GAP
        || this == MAXIMAL_IMPACT_SPEED;
  }

  /** Returns whether it holds for every scenario and has no key. */
  public boolean always() {
    return unit < 0;
  }
}
