package dev.eventchain.simulation.coverage;

import dev.eventchain.messages.Unit;
import dev.eventchain.messages.Unit.Relation;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The two sides of what is symmetric: signals whose names differ in left and right or front and
 * rear, and numbers whose sign is a side.
 */
final class Sides {

  private static final List<List<String>> OPPOSITES =
      List.of(List.of("left", "right"), List.of("front", "rear"));

  /** The part of the other side below which nothing was shown of a side. */
  private static final double CLEAR = 0.1;

  /** The part of the other one's range below which a signal shows clearly less. */
  private static final double HALF = 0.5;

  /** Units of quantities to the left and to the right. */
  private static final List<Unit> TURNS =
      Stream.of("rad", "rad/s", "1/m").map(unit -> Unit.parse(unit).orElseThrow()).toList();

  private static final Pattern SIDEWAYS =
      Pattern.compile("(?i)lateral|yaw|curvature|steer|(^|[._])y(\\[\\])?$");

  /** Angles from north, or from the equator, whose sign is no side. */
  private static final Pattern ABSOLUTE =
      Pattern.compile("(?i)latitude|longitude|heading|bearing|course|azimuth");

  private final Map<String, SignalCoverage> signals = new LinkedHashMap<>();

  Sides(List<SignalCoverage> signals) {
    signals.forEach(each -> this.signals.put(each.name(), each));
  }

  /** Returns the signals on the other side of one. */
  List<SignalCoverage> of(SignalCoverage signal) {
    return OPPOSITES.stream()
        .map(pair -> swapped(signal.name(), pair.get(0), pair.get(1)))
        .filter(name -> !name.equals(signal.name()))
        .map(signals::get)
        .filter(Objects::nonNull)
        .filter(each -> each.kind() == signal.kind())
        .toList();
  }

  private static String swapped(String name, String one, String other) {
    Pattern either = Pattern.compile(one + "|" + other, Pattern.CASE_INSENSITIVE);
    return either
        .matcher(name)
        .replaceAll(
            found -> {
              String word = found.group();
              String opposite = word.equalsIgnoreCase(one) ? other : one;
              return likeCase(word, opposite);
            });
  }

  /** Returns a word with the capitals of another one. */
  private static String likeCase(String pattern, String word) {
    if (pattern.equals(pattern.toUpperCase(Locale.ROOT))) {
      return word.toUpperCase(Locale.ROOT);
    }
    return Character.isUpperCase(pattern.charAt(0))
        ? word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1)
        : word;
  }

  /** Returns that a number covers far less than its counterpart. */
  Optional<String> less(SignalCoverage signal) {
    return of(signal).stream()
        .filter(each -> extent(signal) < HALF * extent(each))
        .map(
            each ->
                "as much as %s, %s, but %s"
                    .formatted(each.name(), Figures.range(each), Figures.range(signal)))
        .findFirst();
  }

  private static double extent(SignalCoverage signal) {
    return signal.most() - signal.least();
  }

  /** Returns that a number to either side is clearly on one only. */
  static Optional<String> sign(SignalCoverage signal) {
    double below = Math.max(0.0, -signal.least());
    double above = Math.max(0.0, signal.most());
    if (!isSideways(signal)
        || !(signal.least() < signal.most())
        || Math.min(below, above) >= CLEAR * Math.max(below, above)) {
      return Optional.empty();
    }
    return Optional.of(
        "%s 0, but %s".formatted(below < above ? "below" : "above", Figures.range(signal)));
  }

  private static boolean isSideways(SignalCoverage signal) {
    boolean turns =
        Unit.parse(signal.unit()).stream()
            .anyMatch(unit -> TURNS.stream().anyMatch(each -> isOf(unit, each)));
    return (turns || SIDEWAYS.matcher(signal.path()).find())
        && !ABSOLUTE.matcher(signal.path()).find();
  }

  private static boolean isOf(Unit unit, Unit other) {
    Relation relation = unit.relationTo(other);
    return relation == Relation.SAME || relation == Relation.CONVERTIBLE;
  }
}
