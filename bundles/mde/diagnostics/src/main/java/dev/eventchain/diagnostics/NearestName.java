package dev.eventchain.diagnostics;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Suggestions of known names for an unknown one. */
public final class NearestName {

  private static final int MOST_NAMES_LISTED = 12;

  private NearestName() {}

  /**
   * Returns the known name nearest to an unknown one, if any is near. Near means at most a third of
   * its characters (at least one) inserted, deleted, changed or swapped, letter case and
   * underscores not counted. Ties are decided by case and underscores, then by alphabetical order.
   */
  public static Optional<String> of(String unknown, Collection<String> known) {
    String plain = plain(unknown);
    int limit = Math.max(1, plain.length() / 3);
    return known.stream()
        .filter(name -> Math.abs(plain(name).length() - plain.length()) <= limit)
        .map(name -> new Near(name, distance(plain, plain(name), limit)))
        .filter(near -> near.distance() <= limit)
        .min(
            Comparator.comparingInt(Near::distance)
                .thenComparingInt(near -> distance(unknown, near.name(), Integer.MAX_VALUE))
                .thenComparing(Near::name))
        .map(Near::name);
  }

  /**
   * Returns the question whether the nearest name was meant; empty if none is near. It never
   * suggests the unknown name itself, which may be known in another role.
   */
  public static String question(String unknown, Collection<String> known) {
    return asked(of(unknown, others(unknown, known)));
  }

  /**
   * Returns a hint: the nearest name, or else all known names that fit in a line; empty if there
   * are none. It never names the unknown name itself, as {@link #question}.
   */
  public static String hint(String unknown, Collection<String> known) {
    List<String> others = others(unknown, known);
    String question = asked(of(unknown, others));
    if (!question.isEmpty()) {
      return question;
    }
    List<String> names = others.stream().distinct().sorted().toList();
    if (names.isEmpty()) {
      return "";
    }
    String listed =
        names.stream()
            .limit(MOST_NAMES_LISTED)
            .map(name -> "`" + name + "`")
            .collect(Collectors.joining(", "));
    return "Known are " + listed + (names.size() > MOST_NAMES_LISTED ? ", ..." : "") + ".";
  }

  private static List<String> others(String unknown, Collection<String> known) {
    return known.stream().filter(name -> !name.equals(unknown)).toList();
  }

  private static String asked(Optional<String> nearest) {
    return nearest.map(name -> "Did you mean `" + name + "`?").orElse("");
  }

  private static String plain(String name) {
    return name.toLowerCase(Locale.ROOT).replace("_", "");
  }

  /** A name with its distance from the unknown one. */
  private record Near(String name, int distance) {}

  /**
   * Returns the optimal string alignment distance: Levenshtein's, with the swap of two neighbours
   * as one step.
   *
   * @param limit the greatest distance of interest: of greater ones, any number above it is
   *     returned, which keeps the search short among a hundred thousand names
   */
  private static int distance(String first, String second, int limit) {
    int[] older = new int[second.length() + 1];
    int[] previous = new int[second.length() + 1];
    int[] current = new int[second.length() + 1];
    for (int j = 0; j <= second.length(); j++) {
      current[j] = j;
    }
    for (int i = 1; i <= first.length(); i++) {
      int[] recycled = older;
      older = previous;
      previous = current;
      current = recycled;
      current[0] = i;
      for (int j = 1; j <= second.length(); j++) {
        boolean equal = first.charAt(i - 1) == second.charAt(j - 1);
        int best = Math.min(previous[j] + 1, current[j - 1] + 1);
        best = Math.min(best, previous[j - 1] + (equal ? 0 : 1));
        boolean swapped =
            i > 1
                && j > 1
                && first.charAt(i - 1) == second.charAt(j - 2)
                && first.charAt(i - 2) == second.charAt(j - 1);
        current[j] = swapped ? Math.min(best, older[j - 2] + 1) : best;
      }
      if (least(previous) > limit && least(current) > limit) {
        return Integer.MAX_VALUE;
      }
    }
    return current[second.length()];
  }

  private static int least(int[] numbers) {
    return IntStream.of(numbers).min().orElse(0);
  }
}
