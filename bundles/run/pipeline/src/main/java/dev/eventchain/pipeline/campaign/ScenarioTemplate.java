package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * A scenario file with the values of factors in place of its own. A path is the keys from the top,
 * with {@code [2]} or {@code [name]} for an element of a list; a key that the file does not have is
 * added.
 */
final class ScenarioTemplate {

  private static final DocumentRules RULES =
      new DocumentRules(
          CampaignRules.SYNTAX,
          CampaignRules.KEY_DUPLICATE,
          CampaignRules.VALUE_TYPE,
          CampaignRules.KEY_MISSING,
          CampaignRules.KEY_UNKNOWN,
          CampaignRules.VALUE_RANGE);
  private static final Pattern STEP = Pattern.compile("([^.\\[\\]]+)|\\[([^\\[\\]]+)]");
  private static final int MOST_TRIED = 200;
  private static final Pattern NUMBER = Pattern.compile("\\d{1,6}");

  private final Path file;
  private final ObjectNode scenario;
  private final Bench bench;
  private final CampaignPlan plan;

  /**
   * Reads the file of a scenario.
   *
   * @throws DiagnosticException (INPUT) if the scenario itself is wrong
   */
  ScenarioTemplate(Path file, Bench bench, CampaignPlan plan) {
    Scenario.read(file, bench);
    this.file = file;
    this.bench = bench;
    this.plan = plan;
    this.scenario =
        (ObjectNode)
            Document.parse(SourceText.read(file), DocumentFormat.YAML, RULES, finding -> {}).root();
  }

  /** Returns a finding for each path that leads nowhere, or where another factor leads. */
  List<Diagnostic> check() {
    List<Diagnostic> found = new ArrayList<>();
    List<String> taken = new ArrayList<>();
    ObjectNode copy = scenario.deepCopy();
    for (Factor factor : plan.factors()) {
      for (String path : factor.paths()) {
        Optional<String> problem = set(copy, path, factor.levels().checked().get(0));
        problem.ifPresent(it -> found.add(Diagnostic.of(CampaignRules.FACTOR, it, factor.place())));
        if (taken.contains(path)) {
          String message = "Two factors have '" + path + "'.";
          found.add(Diagnostic.of(CampaignRules.FACTOR, message, factor.place()));
        }
        taken.add(path);
      }
    }
    return found.isEmpty() ? values() : found;
  }

  /**
   * Returns a finding for each factor with a value that no scenario takes, with the others as they
   * are first. Of very many values, some are tried, the first and the last among them.
   */
  private List<Diagnostic> values() {
    List<Diagnostic> found = new ArrayList<>();
    List<BigDecimal> first =
        plan.factors().stream().map(factor -> factor.levels().checked().get(0)).toList();
    CampaignCase usual = new CampaignCase(first, 1);
    for (int i = 0; i < plan.factors().size(); i++) {
      Factor factor = plan.factors().get(i);
      for (BigDecimal value : some(factor.levels().checked())) {
        Optional<String> problem = refusal(usual.with(i, value));
        if (problem.isPresent()) {
          String words = factor.name() + " = " + value.toPlainString();
          found.add(
              Diagnostic.of(
                  CampaignRules.FACTOR, "With " + words + ": " + problem.get(), factor.place()));
          break;
        }
      }
    }
    return found;
  }

  private static List<BigDecimal> some(List<BigDecimal> values) {
    int last = values.size() - 1;
    int most = Math.min(last, MOST_TRIED);
    return IntStream.rangeClosed(0, most)
        .mapToObj(i -> values.get(most == 0 ? 0 : (int) ((long) i * last / most)))
        .toList();
  }

  private Optional<String> refusal(CampaignCase each) {
    try {
      of(each);
      return Optional.empty();
    } catch (DiagnosticException e) {
      Diagnostic first = e.diagnostics().get(0);
      return Optional.of(first.message() + " " + first.location().element());
    }
  }

  /**
   * Returns the scenario of a case.
   *
   * @throws DiagnosticException (INPUT) if its values do not fit together
   */
  Scenario of(CampaignCase each) {
    return Scenario.parse(SourceText.of(file.toString(), text(each)), bench);
  }

  /** Returns the scenario of a case as JSON, which is YAML, too. */
  String text(CampaignCase each) {
    ObjectNode copy = scenario.deepCopy();
    for (int i = 0; i < plan.factors().size(); i++) {
      for (String path : plan.factors().get(i).paths()) {
        set(copy, path, each.values().get(i));
      }
    }
    if (plan.repetitions() > 1) {
      long seed = scenario.path("seed").asLong(1);
      copy.set("seed", LongNode.valueOf(seed + each.repetition() - 1));
    }
    return copy.toPrettyString();
  }

  /** Sets a number; returns what is wrong with its path. */
  private static Optional<String> set(ObjectNode root, String path, BigDecimal value) {
    List<String> steps = steps(path);
    if (steps.isEmpty()) {
      return Optional.of("'" + path + "' is no path, such as actors[0].gap_m.");
    }
    JsonNode node = root;
    for (int i = 0; i + 1 < steps.size(); i++) {
      String step = steps.get(i);
      Optional<JsonNode> next =
          step.startsWith("[") ? element(node, step) : property(node, step, steps.get(i + 1));
      if (next.isEmpty()) {
        return Optional.of("The scenario has no " + step + " for the path '" + path + "'.");
      }
      node = next.get();
    }
    String last = steps.get(steps.size() - 1);
    if (last.startsWith("[") || !(node instanceof ObjectNode owner)) {
      return Optional.of("'" + path + "' is not the path of a number.");
    }
    JsonNode before = owner.get(last);
    if (before != null && !before.isNumber()) {
      return Optional.of("'" + path + "' is " + before.getNodeType() + ", and not a number.");
    }
    owner.set(last, DecimalNode.valueOf(value));
    return Optional.empty();
  }

  /** Returns the keys and {@code [...]} of a path; none if it is no path. */
  private static List<String> steps(String path) {
    List<String> steps = new ArrayList<>();
    Matcher step = STEP.matcher(path);
    int end = 0;
    while (step.find()) {
      String between = path.substring(end, step.start());
      boolean joined = between.isEmpty() ? step.group(1) == null || end == 0 : between.equals(".");
      if (!joined) {
        return List.of();
      }
      steps.add(step.group(1) != null ? step.group(1) : step.group());
      end = step.end();
    }
    return end == path.length() ? steps : List.of();
  }

  private static Optional<JsonNode> element(JsonNode list, String step) {
    String which = step.substring(1, step.length() - 1).strip();
    if (!(list instanceof ArrayNode)) {
      return Optional.empty();
    }
    if (NUMBER.matcher(which).matches()) {
      return Optional.ofNullable(list.get(Integer.parseInt(which)));
    }
    for (JsonNode each : list) {
      if (each.path("name").asText().equals(which)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  /** Returns the value of a key, which is added where a key of it follows. */
  private static Optional<JsonNode> property(JsonNode node, String key, String following) {
    if (!(node instanceof ObjectNode owner)) {
      return Optional.empty();
    }
    if (!owner.has(key) && !following.startsWith("[")) {
      owner.putObject(key);
    }
    return Optional.ofNullable(owner.get(key));
  }

  /** Returns the file of a scenario of a project by its name. */
  static Path find(List<Path> files, List<Scenario> scenarios, CampaignPlan plan) {
    List<String> names = scenarios.stream().map(Scenario::name).toList();
    int index = names.indexOf(plan.scenario());
    if (index < 0) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  CampaignRules.FACTOR,
                  "The project has no scenario '" + plan.scenario() + "'.",
                  SourceLocation.of(plan.file()))
              .withHint(NearestName.hint(plan.scenario(), names)));
    }
    return files.get(index);
  }
}
