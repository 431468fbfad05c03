package dev.eventchain.simulation.strength;

import dev.eventchain.messages.Unit;
import dev.eventchain.messages.Unit.Relation;
import java.util.List;
import java.util.Optional;

/**
 * Size of the standard faults of a number, which its unit makes relevant.
 *
 * @param factor the factor of scaling up; its inverse scales down
 * @param shift the shift in the unit of the number
 */
record Magnitude(double factor, double shift) {

  /** The factor where no confusion of units suggests another one. */
  private static final double TWICE = 2;

  /** The part of the range of values by which a number without a known unit is shifted. */
  private static final double PART = 0.2;

  /** A dimension, with the usual confusion of its units and a shift in coherent units. */
  private record Usual(Unit unit, double factor, double shift) {

    private static Usual of(String unit, double factor, double shift) {
      return new Usual(Unit.parse(unit).orElseThrow(), factor, shift);
    }
  }

  private static final List<Usual> USUAL =
      List.of(
          Usual.of("m", TWICE, 1),
          Usual.of("s", TWICE, 0.5),
          Usual.of("m/s", 3.6, 1),
          Usual.of("m/s2", TWICE, 1),
          Usual.of("rad", 180 / Math.PI, Math.toRadians(5)),
          Usual.of("rad/s", 180 / Math.PI, Math.toRadians(5)));

  /**
   * Returns the size of faults.
   *
   * @param unit the unit of the number; may be empty or unknown
   * @param least the smallest value that it has without faults
   * @param most the largest value that it has without faults
   */
  static Magnitude of(String unit, double least, double most) {
    Optional<Unit> known = unit.isBlank() ? Optional.empty() : Unit.parse(unit);
    return known
        .flatMap(it -> USUAL.stream().filter(each -> isOf(it, each.unit())).findFirst())
        .map(each -> new Magnitude(each.factor(), shift(known.get(), each.shift())))
        .orElseGet(() -> new Magnitude(TWICE, PART * extent(least, most)));
  }

  private static boolean isOf(Unit unit, Unit other) {
    Relation relation = unit.relationTo(other);
    return relation == Relation.SAME || relation == Relation.CONVERTIBLE;
  }

  private static double shift(Unit unit, double coherent) {
    return unit.ofCoherent(coherent) - unit.ofCoherent(0);
  }

  private static double extent(double least, double most) {
    double extent = most > least ? most - least : Math.max(Math.abs(most), Math.abs(least));
    return extent > 0 && Double.isFinite(extent) ? extent : 1;
  }
}
