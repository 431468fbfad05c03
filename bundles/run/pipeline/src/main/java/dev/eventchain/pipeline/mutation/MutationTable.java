package dev.eventchain.pipeline.mutation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;

/** A line for each component or module: how many of its mutants were noticed, and by what. */
final class MutationTable {

  /** Least width of the names. */
  private static final int WIDTH = 28;

  private MutationTable() {}

  /**
   * Returns the table.
   *
   * @param results those of the tried mutants, in the order of the chain
   * @param accepted tells the accepted survivors
   */
  static String of(List<MutantResult> results, Predicate<MutantResult> accepted) {
    Map<String, List<MutantResult>> components = new LinkedHashMap<>();
    for (MutantResult result : results) {
      components.computeIfAbsent(result.component(), name -> new ArrayList<>()).add(result);
    }
    int width = components.keySet().stream().mapToInt(String::length).reduce(WIDTH, Math::max);
    StringBuilder table = new StringBuilder();
    table.append(line(width, "component", "mutants", "by test", "by run", "accepted", "survive"));
    components.forEach((name, all) -> table.append(row(width, name, all, accepted)));
    if (components.size() > 1) {
      table.append(row(width, "all", results, accepted));
    }
    return table.toString();
  }

  private static String row(
      int width, String name, List<MutantResult> results, Predicate<MutantResult> accepted) {
    long tests =
        results.stream().filter(each -> each.outcome() == MutantResult.Outcome.TEST).count();
    long caught = results.stream().filter(each -> each.outcome().isCaught()).count();
    long explained = results.stream().filter(MutantResult::survives).filter(accepted).count();
    long survive = results.stream().filter(MutantResult::survives).count() - explained;
    return line(width, name, results.size(), tests, caught - tests, explained, survive);
  }

  private static String line(int width, Object... cells) {
    return String.format(Locale.ROOT, "%-" + width + "s %8s %8s %8s %8s %8s%n", cells);
  }
}
