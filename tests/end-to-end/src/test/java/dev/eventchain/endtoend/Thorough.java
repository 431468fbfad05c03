package dev.eventchain.endtoend;

import java.util.List;

/** Whether the build tries everything, as the profile {@code thorough} does. */
final class Thorough {

  /** A build tries one in this many defects of the examples, other ones each day. */
  static final int DAYS = Integer.getInteger("mutants.of.examples", 27);

  static final boolean IS_ON = DAYS == 1;

  private Thorough() {}

  /** Returns all in the profile {@code thorough}, else the first. */
  static <T> List<T> allOrFirst(List<T> all) {
    return IS_ON ? all : all.subList(0, 1);
  }
}
