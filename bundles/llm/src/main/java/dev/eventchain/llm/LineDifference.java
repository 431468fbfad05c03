package dev.eventchain.llm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What changed between two texts, line by line, as an excerpt in the manner of a unified diff. */
final class LineDifference {
  private static final int CONTEXT = 1;

  private final List<String> before;
  private final List<String> after;

  LineDifference(List<String> before, List<String> after) {
    this.before = before;
    this.after = after;
  }

  /** How many lines of the one are not in the other, counted without regard to their order. */
  int distance() {
    Map<String, Integer> surplus = new HashMap<>();
    before.forEach(line -> surplus.merge(line, 1, Integer::sum));
    after.forEach(line -> surplus.merge(line, -1, Integer::sum));
    return surplus.values().stream().mapToInt(Math::abs).sum();
  }

  /**
   * The first changes with a line of context around them, at most {@code limit} lines; then the
   * number of lines left out.
   */
  List<String> excerpt(int limit) {
    List<String> all = script();
    List<String> shown = new ArrayList<>();
    int last = -1;
    for (int i = 0; i < all.size(); i++) {
      if (!nearChange(all, i)) {
        continue;
      }
      if (last >= 0 && i > last + 1) {
        shown.add("  ...");
      }
      shown.add(all.get(i));
      last = i;
    }
    if (shown.size() <= limit) {
      return shown;
    }
    List<String> cut = new ArrayList<>(shown.subList(0, limit));
    cut.add("  ... and %d more lines".formatted(shown.size() - limit));
    return cut;
  }

  private static boolean nearChange(List<String> script, int index) {
    for (int i = Math.max(0, index - CONTEXT); i <= index + CONTEXT && i < script.size(); i++) {
      if (script.get(i).charAt(0) != ' ') {
        return true;
      }
    }
    return false;
  }

  // Lines in common at both ends are set aside first: prompts usually differ in one place, and the
  // table below is quadratic.
  private List<String> script() {
    int start = 0;
    while (start < Math.min(before.size(), after.size())
        && before.get(start).equals(after.get(start))) {
      start++;
    }
    int end = 0;
    while (end < Math.min(before.size(), after.size()) - start
        && before.get(before.size() - 1 - end).equals(after.get(after.size() - 1 - end))) {
      end++;
    }
    List<String> script = new ArrayList<>();
    before.subList(0, start).forEach(line -> script.add("  " + line));
    appendMiddle(
        script,
        before.subList(start, before.size() - end),
        after.subList(start, after.size() - end));
    before.subList(before.size() - end, before.size()).forEach(line -> script.add("  " + line));
    return script;
  }

  private static void appendMiddle(List<String> script, List<String> old, List<String> fresh) {
    int[][] common = commonLengths(old, fresh);
    int i = 0;
    int j = 0;
    while (i < old.size() || j < fresh.size()) {
      if (i < old.size() && j < fresh.size() && old.get(i).equals(fresh.get(j))) {
        script.add("  " + old.get(i++));
        j++;
      } else if (j == fresh.size() || (i < old.size() && common[i + 1][j] >= common[i][j + 1])) {
        script.add("- " + old.get(i++));
      } else {
        script.add("+ " + fresh.get(j++));
      }
    }
  }

  private static int[][] commonLengths(List<String> old, List<String> fresh) {
    int[][] common = new int[old.size() + 1][fresh.size() + 1];
    for (int i = old.size() - 1; i >= 0; i--) {
      for (int j = fresh.size() - 1; j >= 0; j--) {
        common[i][j] =
            old.get(i).equals(fresh.get(j))
                ? common[i + 1][j + 1] + 1
                : Math.max(common[i + 1][j], common[i][j + 1]);
      }
    }
    return common;
  }
}
