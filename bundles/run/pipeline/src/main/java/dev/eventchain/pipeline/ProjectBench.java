package dev.eventchain.pipeline;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.WorldReference;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.xmi.LoadedModel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The simulated world's inputs and outputs, and their connections with a project.
 *
 * @param text the listing, for people
 * @param diagnostics the findings about missing connections; none while there is no chain
 */
public record ProjectBench(String text, List<Diagnostic> diagnostics) {

  /** A word of an operator as it is written; operands are single letters. */
  private static final Pattern OPERATOR = Pattern.compile("\\b[a-z]{2,}\\b");

  /** Copies the list. */
  public ProjectBench {
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Describes the bench of a project.
   *
   * @param output the folder of the project's results, which may contain its model
   * @throws DiagnosticException INPUT if the bench, the software base or the model cannot be read
   */
  public static ProjectBench of(Project project, Path output) {
    SoftwareBase base = project.readSoftwareBase();
    Bench bench = read(project, base);
    List<Diagnostic> found = new ArrayList<>(base.diagnostics());
    Optional<Path> file = project.model(output);
    if (file.isEmpty()) {
      return new ProjectBench(bench.listing(Optional.empty()), found);
    }
    LoadedModel model = EventChainMetamodel.store(file.get().resolveSibling("")).load(file.get());
    EventChain chain = ChainModel.chainOf(model, file.get());
    found.addAll(bench.check(chain, model.origins()::locate));
    return new ProjectBench(bench.listing(Optional.of(chain)), found);
  }

  /**
   * Reads the bench of a project by itself, whatever its chain is.
   *
   * @throws DiagnosticException INPUT if the bench or the software base cannot be read
   */
  public static Bench read(Project project) {
    return read(project, project.readSoftwareBase());
  }

  private static Bench read(Project project, SoftwareBase base) {
    return Bench.read(
        project.bench(),
        base.signals().orElse(List.of()),
        MessageCatalog.of(project.distribution(), project.messageFolders()));
  }

  /**
   * Returns the text of {@code bench.yaml} for signals that a software base declares.
   *
   * @param messages the definitions of their types
   * @param rates the known rates of topics in Hz, by their full names
   */
  public static String proposal(
      List<Signal> signals, MessageCatalog messages, Map<String, Double> rates) {
    return Bench.proposal(signals, messages, rates);
  }

  /** Returns the JSON Schema of {@code bench.yaml}. */
  public static String schema() {
    return Bench.schema();
  }

  /** Returns the JSON Schema of a scenario. */
  public static String scenarioSchema() {
    return Scenario.schema();
  }

  /** Returns the JSON Schema of files with faults. */
  public static String faultsSchema() {
    return FaultPlan.schema();
  }

  /**
   * A word of formulas.
   *
   * @param isOperator true for an operator or a function, false for a quantity of the world
   * @param unit that of a quantity; empty for a truth value or an operator
   * @param about what it means, in Markdown
   */
  public record FormulaWord(boolean isOperator, String unit, String about) {}

  /** Returns the words of formulas that no project declares: operators and quantities. */
  public static Map<String, FormulaWord> formulaWords() {
    Map<String, FormulaWord> words = new LinkedHashMap<>();
    for (WorldReference.OperatorEntry each : WorldReference.operators()) {
      String about = "`" + each.written() + "`: " + each.meaning();
      Matcher word = OPERATOR.matcher(each.written());
      while (word.find()) {
        words.putIfAbsent(word.group(), new FormulaWord(true, "", about));
      }
    }
    for (WorldReference.Entry each : WorldReference.quantities()) {
      String unit = each.unit().isEmpty() ? "true or false" : "in " + each.unit();
      words.put(each.name(), new FormulaWord(false, each.unit(), unit + ": " + each.meaning()));
    }
    return words;
  }

  /**
   * Returns the units of benches and formulas, those first whose numbers can be converted to
   * another one.
   *
   * @param like the other one, which comes first of all; none comes first if it is unknown
   */
  public static List<String> units(String like) {
    Optional<Unit> wanted = Unit.parse(like);
    Stream<String> written = wanted.isPresent() ? Stream.of(like) : Stream.empty();
    return Stream.concat(written, WorldReference.units().stream())
        .distinct()
        .sorted(Comparator.comparing(each -> !wanted.map(it -> isOf(each, it)).orElse(false)))
        .toList();
  }

  private static boolean isOf(String unit, Unit other) {
    return switch (Unit.parse(unit).orElseThrow().relationTo(other)) {
      case SAME, CONVERTIBLE -> true;
      case ANGLE, INCOMPATIBLE -> false;
    };
  }
}
