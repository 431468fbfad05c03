package dev.eventchain.pipeline.design;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Curve;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A failed verdict as text for a language model: each missed criterion with the words of the
 * requirements that it judges, and the inputs and outputs of components around the decisive time.
 */
final class VerdictText {
  /** Largest number of criteria: further ones usually have the same cause. */
  private static final int MOST_CRITERIA = 5;

  private static final int MOST_OTHERS = 6;
  private static final double BEFORE = 0.6; // s
  private static final double AFTER = 0.2; // s

  private final List<SoftwareNode> components;
  private final FailedScenarios failed;
  private final StringBuilder text = new StringBuilder();

  private VerdictText(List<SoftwareNode> components, FailedScenarios failed) {
    this.components = components;
    this.failed = failed;
  }

  /**
   * Returns the failed criteria as text.
   *
   * @param components those whose inputs and outputs are shown
   */
  static String of(List<SoftwareNode> components, FailedScenarios failed) {
    VerdictText told = new VerdictText(components, failed);
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
    return told.text.toString();
  }

  private void add(int number, ScenarioVerdict verdict, CriterionResult criterion) {
    List<Double> times = verdict.series().time();
    double end = times.isEmpty() ? 0 : times.get(times.size() - 1);
    double time = criterion.decided().orElse(end);
    text.append(
        String.format(
            Locale.ROOT,
            "%d. Scenario \"%s\" (%s), at %.2f s: expected %s, but found: %s.\n",
            number,
            verdict.title(),
            String.join(", ", criterion.requirements()),
            time,
            criterion.text(),
            criterion.measured()));
    failed
        .words(verdict, criterion)
        .forEach(
            it -> text.append("   It judges %s: \"%s\"\n".formatted(it.requirement(), it.words())));
    if (criterion.tested()) {
      addTable(verdict, time);
    }
  }

  private void addTable(ScenarioVerdict verdict, double time) {
    List<Integer> rows = rows(verdict.series().time(), time);
    Map<String, Curve> columns = columns(verdict.series().curves(), rows);
    text.append("\n| time [s] |");
    columns.forEach((name, curve) -> text.append(" %s [%s] |".formatted(name, curve.unit())));
    text.append("\n|---|").append("---|".repeat(columns.size())).append('\n');
    for (int row : rows) {
      text.append(String.format(Locale.ROOT, "| %.2f |", verdict.series().time().get(row)));
      columns.values().forEach(curve -> text.append(cell(curve.values().get(row))));
      text.append('\n');
    }
    text.append('\n');
  }

  private static String cell(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, " %.4g |", value) : " - |";
  }

  /** Returns the components' own signals, then some of the others that change. */
  private Map<String, Curve> columns(List<Curve> curves, List<Integer> rows) {
    Map<String, Curve> columns = new LinkedHashMap<>();
    for (Curve curve : curves) {
      own(curve).ifPresent(name -> columns.put(name, curve));
    }
    int own = columns.size();
    for (Curve curve : curves) {
      long values = rows.stream().map(row -> curve.values().get(row)).distinct().count();
      if (values > 1 && own(curve).isEmpty() && columns.size() < own + MOST_OTHERS) {
        columns.put(curve.name(), curve);
      }
    }
    return columns;
  }

  private Optional<String> own(Curve curve) {
    return components.stream().flatMap(each -> own(each, curve).stream()).findFirst();
  }

  private Optional<String> own(SoftwareNode component, Curve curve) {
    if (components.size() > 1) { // One's output is the other's input, under the name of its topic.
      return name(component.getInput(), curve.name(), "")
          .or(() -> name(component.getOutput(), curve.name(), ""))
          .map(name -> curve.name());
    }
    return name(component.getInput(), curve.name(), "input ")
        .or(() -> name(component.getOutput(), curve.name(), "output "));
  }

  private static Optional<String> name(List<Data> data, String curve, String kind) {
    return data.stream()
        .filter(each -> curve.equals(each.getTopicName() + "." + each.getFieldName()))
        .map(each -> kind + each.getName())
        .findFirst();
  }

  private static List<Integer> rows(List<Double> times, double time) {
    return IntStream.range(0, times.size())
        .filter(i -> times.get(i) >= time - BEFORE && times.get(i) <= time + AFTER)
        .boxed()
        .toList();
  }
}
