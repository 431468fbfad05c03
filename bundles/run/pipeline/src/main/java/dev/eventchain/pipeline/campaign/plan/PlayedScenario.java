package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.scenario.VariedScenario;
import java.math.BigDecimal;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * A file in OpenSCENARIO XML that a campaign is about, in place of a scenario.
 *
 * @param file the file: of a scenario, or of distributions
 * @param accept what is required: {@code KEY} or {@code KEY=NUMBER} each; empty if only other
 *     criteria of the campaign file say it
 */
public record PlayedScenario(Path file, VariedScenario varied, List<String> accept) {

  /** The path of a parameter in a scenario that plays the file, without its name. */
  public static final String PATH = "openscenario.parameters.";

  /** Cases of a scenario whose parameters have bounds only. */
  public static final int DRAWN = 100;

  private static final String ACCEPT = "accept";

  /** Copies the criteria. */
  public PlayedScenario {
    accept = List.copyOf(accept);
  }

  /**
   * Reads the file that a campaign names, if it is one; what is wrong with the campaign is found
   * there.
   *
   * @param given the criteria that the campaign file gives its cases elsewhere
   * @throws DiagnosticException with the problems of the file
   */
  static Optional<PlayedScenario> read(
      Path campaign, String scenario, ObjectReader section, List<CaseCriteria> given) {
    Optional<Path> named = file(campaign, scenario);
    if (named.isEmpty()) {
      return Optional.empty();
    }
    Path file = named.get();
    List<String> accept = section.texts(ACCEPT);
    if (accept.isEmpty()
        && (section.has(ACCEPT) || given.stream().noneMatch(CaseCriteria::areOfAll))) {
      section.find(
          Diagnostic.of(
                  CampaignRules.KEY_MISSING,
                  "An OpenSCENARIO file does not say what is required of the software.",
                  section.at(section.has(ACCEPT) ? ACCEPT : "scenario"))
              .withHint("Write `accept: [no_impact]`, or another criterion without a value."));
    }
    return Optional.of(new PlayedScenario(file, VariedScenario.read(file), accept));
  }

  /** Returns the file that a campaign names; empty if it names a scenario, or no path at all. */
  private static Optional<Path> file(Path campaign, String scenario) {
    try {
      return scenario.isEmpty()
          ? Optional.empty()
          : Optional.of(campaign.resolveSibling(scenario)).filter(VariedScenario::isOne);
    } catch (InvalidPathException e) {
      return Optional.empty(); // Such a scenario is not found, either.
    }
  }

  /** Returns why what varies in a file cannot be factors. */
  public static Optional<Diagnostic> refusal(Path file, VariedScenario varied, Purpose purpose) {
    if (varied.parameters().isEmpty()) {
      return refused(
          file,
          CampaignRules.EMPTY,
          "Nothing varies in this file: no number among its parameters has a lower and an upper"
              + " limit, or two values.",
          "Give a parameter a ConstraintGroup with both limits, name a file of parameter value"
              + " distributions, or write a campaign file with the parameter as a factor.");
    }
    for (VariedScenario.Parameter each : varied.parameters()) {
      if (!each.isNumeric()) {
        return refused(
            file,
            CampaignRules.FACTOR,
            "'" + each.name() + "' differs between the cases, and its values are no numbers.",
            "Simulate the file: `eventchain simulate DIR --scenario-file "
                + file.getFileName()
                + " --accept ...`.");
      }
    }
    return purpose == Purpose.SEARCH ? refusalOfSearch(file, varied) : Optional.empty();
  }

  private static Optional<Diagnostic> refusalOfSearch(Path file, VariedScenario varied) {
    return varied.rows().isEmpty()
        ? Optional.empty()
        : refused(
            file,
            CampaignRules.FACTOR,
            "The cases of this file are not all combinations of their values, between which a"
                + " search could go.",
            "Use `campaign`, or write a campaign file with the bounds of each parameter.");
  }

  private static Optional<Diagnostic> refused(Path file, Rule rule, String message, String hint) {
    return Optional.of(Diagnostic.of(rule, message, SourceLocation.of(file)).withHint(hint));
  }

  /** Returns names for factors, which are words, of the parameters that vary. */
  public static List<String> names(VariedScenario varied) {
    Set<String> names = new LinkedHashSet<>();
    for (VariedScenario.Parameter each : varied.parameters()) {
      String name = each.name().replaceAll("[^A-Za-z0-9_]", "_").replaceFirst("^(?=\\d)", "_");
      while (!names.add(name)) {
        name += "_";
      }
    }
    return List.copyOf(names);
  }

  /** Returns the factors of a campaign that states none: all that varies. */
  List<Factor> factors(SourceLocation place) {
    List<String> names = names(varied);
    return IntStream.range(0, names.size())
        .mapToObj(
            i -> {
              List<String> paths = List.of(PATH + varied.parameters().get(i).name());
              return new Factor(names.get(i), paths, levels(i), place);
            })
        .toList();
  }

  private Levels levels(int index) {
    VariedScenario.Parameter parameter = varied.parameters().get(index);
    if (!varied.rows().isEmpty()) {
      return new Levels.Column(
          file.getFileName().toString(),
          varied.rows().stream().map(row -> new BigDecimal(row.get(index))).toList());
    }
    List<BigDecimal> numbers =
        parameter.numbers().stream().map(number -> number.decimalValue()).toList();
    return parameter.isRange()
        ? new Levels.Uniform(numbers.get(0), numbers.get(1))
        : new Levels.Listed(numbers);
  }

  /** Returns how the values of {@link #factors} are combined where the campaign does not say. */
  Sampling sampling(Purpose purpose) {
    if (!varied.rows().isEmpty()) {
      return new Sampling(Sampling.Kind.ROWS, 0);
    }
    boolean ranges = varied.parameters().stream().anyMatch(VariedScenario.Parameter::isRange);
    return ranges && purpose == Purpose.CAMPAIGN
        ? new Sampling(Sampling.Kind.HALTON, DRAWN)
        : Sampling.USUAL;
  }

  /** Returns a factor; one without a path that is called as a parameter has the value of that. */
  Factor addressed(Factor factor) {
    return factor.paths().isEmpty() && varied.declared().containsKey(factor.name())
        ? new Factor(factor.name(), List.of(PATH + factor.name()), factor.levels(), factor.place())
        : factor;
  }

  /**
   * Returns a scenario that plays the file.
   *
   * @param path of the file that it plays, as the scenario names it
   * @param paths of the factors and of what is computed
   */
  public ObjectNode written(String path, Stream<String> paths) {
    Set<String> parameters = new HashSet<>();
    paths
        .filter(each -> each.startsWith(PATH))
        .forEach(each -> parameters.add(each.substring(PATH.length())));
    return varied.written(path, accept, parameters);
  }
}
