package dev.eventchain.endtoend;

import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;

/** Whether the build tries everything, as the profile {@code thorough} does. */
final class Thorough {

  /** A build tries one in this many defects of the examples, other ones each day. */
  static final int DAYS = Integer.getInteger("mutants.of.examples", 27);

  static final boolean IS_ON = DAYS == 1;

  private Thorough() {}

  /** Returns the number of the day, which decides what a build tries; {@code -Dmutants.turn=N}. */
  static long turn() {
    return Long.getLong("mutants.turn", LocalDate.now(ZoneOffset.UTC).toEpochDay());
  }

  /** Returns all in the profile {@code thorough}, else the first. */
  static <T> List<T> allOrFirst(List<T> all) {
    return IS_ON ? all : all.subList(0, 1);
  }

  /** Returns all in the profile {@code thorough}, else one, another one each day. */
  static <T> List<T> allOrOne(List<T> all) {
    return IS_ON ? all : List.of(all.get(Math.floorMod(turn(), all.size())));
  }
}
