package dev.eventchain.ocl;

import java.util.Collection;
import java.util.Locale;

/** Finds the name that was probably meant. */
public final class NearestName {

  private NearestName() {}

  /** The nearest of some names; empty if none is near. Of equally near names the first one. */
  public static String of(String name, Collection<String> names) {
    int best = Math.max(1, name.length() / 3) + 1;
    String nearest = "";
    for (String candidate : names) {
      int distance =
          candidate.equalsIgnoreCase(name)
              ? 0
              : distance(name.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT));
      if (distance < best && !candidate.equals(name)) {
        best = distance;
        nearest = candidate;
      }
    }
    return nearest;
  }

  /** "Did you mean 'x'?" for the nearest of some names; empty if none is near. */
  public static String question(String name, Collection<String> names) {
    String nearest = of(name, names);
    return nearest.isEmpty() ? "" : "Did you mean '" + nearest + "'?";
  }

  /** The Levenshtein distance with swaps of neighbours (optimal string alignment). */
  private static int distance(String a, String b) {
    int[] beforeLast = new int[b.length() + 1];
    int[] last = new int[b.length() + 1];
    int[] current = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      last[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      current[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        boolean same = a.charAt(i - 1) == b.charAt(j - 1);
        int cost = Math.min(last[j], current[j - 1]) + 1;
        cost = Math.min(cost, last[j - 1] + (same ? 0 : 1));
        boolean swapped =
            i > 1
                && j > 1
                && a.charAt(i - 1) == b.charAt(j - 2)
                && a.charAt(i - 2) == b.charAt(j - 1);
        current[j] = swapped ? Math.min(cost, beforeLast[j - 2] + 1) : cost;
      }
      int[] spare = beforeLast;
      beforeLast = last;
      last = current;
      current = spare;
    }
    return last[b.length()];
  }
}
