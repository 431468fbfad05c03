package dev.eventchain.pipeline.design;

import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.List;
import java.util.Locale;

/**
 * A failed verdict as text for a language model: each missed criterion with the words of the
 * requirements that it judges, and the inputs and outputs of components around the decisive time.
 */
final class VerdictText {
  /** Largest number of criteria: further ones usually have the same cause. */
  private static final int MOST_CRITERIA = 5;

  private static final int MOST_TABLES = 3;

  private static final String LEGEND =
      """

      Times are in seconds since the start of the scenario. In the tables, a row has each message \
      that came from its time until the next row's, and the numbers of the world at its time; of \
      an array, the smallest and the largest finite element, and how many are finite. The row \
      that decides is marked; a row marked "good" has what held at the nearest time at which what \
      decides was the other way round.
      """;

  private final List<SoftwareNode> components;
  private final StringBuilder text = new StringBuilder();
  private boolean hasTable;

  private VerdictText(List<SoftwareNode> components) {
    this.components = components;
  }

  /**
   * Returns the failed criteria as text.
   *
   * @param components those whose inputs and outputs are shown
   */
  static String of(List<SoftwareNode> components, FailedScenarios failed) {
    VerdictText told = new VerdictText(components);
    int number = 0;
    for (ScenarioVerdict verdict : failed.verdicts()) {
      for (CriterionResult criterion : failed.missed(verdict)) {
        if (++number <= MOST_CRITERIA) {
          told.add(number, verdict, criterion);
        }
      }
    }
    if (number > MOST_CRITERIA) {
      told.text.append("And ").append(number - MOST_CRITERIA).append(" more.\n");
    }
    return told.text.append(told.hasTable ? LEGEND : "\n").toString();
  }

  private void add(int number, ScenarioVerdict verdict, CriterionResult criterion) {
    text.append(
        String.format(
            Locale.ROOT,
            "%d. Scenario \"%s\" (%s), at %.2f s: expected %s, but found: %s.\n",
            number,
            verdict.title(),
            String.join(", ", criterion.requirements()),
            SampleTable.time(verdict, criterion),
            criterion.text(),
            criterion.measured()));
    criterion
        .judges()
        .forEach(
            it -> text.append("   It judges %s: \"%s\"\n".formatted(it.requirement(), it.words())));
    if (criterion.tested() && number <= MOST_TABLES) {
      text.append(SampleTable.of(components, verdict, criterion));
      hasTable = true;
    }
  }
}
