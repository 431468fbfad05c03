package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.pipeline.campaign.plan.CampaignCase;
import dev.eventchain.pipeline.campaign.plan.CampaignPlan;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.CaseList;
import dev.eventchain.pipeline.campaign.plan.Factor;
import dev.eventchain.pipeline.campaign.plan.NumberPath;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.pipeline.campaign.plan.SearchSettings;
import dev.eventchain.pipeline.campaign.result.CampaignRow;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.CaseReader;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A scenario file, and the project's {@code bench.yaml}, with the values of factors in place of
 * their own numbers.
 */
final class ScenarioTemplate {

  private static final String BENCH = NumberPath.BENCH;
  private static final String PHASE = "phases_ms.";
  private static final String PLAYED = "openscenario";
  private static final String PLAYED_FILE = "file";

  /** A number that is larger than any in a scenario or a bench. */
  private static final long FIRST_MARK = 1L << 60;

  private final Bench usualBench;
  private final Function<SourceText, Bench> benches;
  private final Optional<Path> benchFile;
  private final List<String> nodes;
  private final CampaignPlan plan;
  private final Path file;
  private final ObjectNode scenario;
  private final Optional<ObjectNode> bench;
  private final boolean variesBench;
  private final CriteriaOfCases criteria;
  private final Optional<CriteriaOfPoints> points;
  private final CaseReader cases = new CaseReader();

  /**
   * Reads the file of a scenario, and the bench.
   *
   * @throws DiagnosticException (INPUT) if the scenario itself is wrong
   */
  ScenarioTemplate(CampaignWorld world, CampaignPlan plan, Path file) {
    this.usualBench = world.bench();
    this.benches = world.benches();
    this.benchFile = world.benchFile();
    this.nodes = world.nodes();
    Scenario.read(file, usualBench);
    this.plan = plan;
    this.file = file;
    Document document = document(SourceText.read(file));
    this.criteria = new CriteriaOfCases(plan, document::at);
    this.points = plan.points().map(it -> new CriteriaOfPoints(plan, it, this::texts));
    this.scenario = criteria.withThoseOfAll((ObjectNode) document.root());
    this.bench = benchFile.map(it -> tree(SourceText.read(it)));
    this.variesBench =
        paths(plan).values().stream().flatMap(List::stream).anyMatch(it -> it.startsWith(BENCH));
  }

  /** Returns the paths of all factors and of what is computed, by their places in the file. */
  private static Map<SourceLocation, List<String>> paths(CampaignPlan plan) {
    Map<SourceLocation, List<String>> paths = new LinkedHashMap<>();
    plan.factors().forEach(factor -> paths.put(factor.place(), factor.paths()));
    plan.computed().forEach(each -> paths.put(each.place(), each.paths()));
    return paths;
  }

  private static ObjectNode tree(SourceText text) {
    return (ObjectNode) document(text).root();
  }

  private static Document document(SourceText text) {
    return Document.parse(text, DocumentFormat.YAML, CampaignRules.OF_DOCUMENTS, finding -> {});
  }

  /** Returns the texts of the criteria of each kind of cases to which a search may come. */
  List<List<String>> criteriaOfSearch() {
    return textsOfKinds(criteria.kinds(new SearchSpace(plan).tried()));
  }

  private List<List<String>> textsOfKinds(Collection<List<CampaignCase>> kinds) {
    return kinds.stream()
        .flatMap(kind -> kind.stream().map(this::texts).filter(it -> !it.isEmpty()).limit(1))
        .toList();
  }

  /** Returns the texts of the criteria of a case; none if it cannot be read. */
  private List<String> texts(CampaignCase each) {
    try {
      return texts(read(each));
    } catch (DiagnosticException e) {
      return List.of();
    }
  }

  private static List<String> texts(CaseSimulation.Case each) {
    return each.scenario().criteria().stream().map(Expectation::text).toList();
  }

  /**
   * Returns a finding for each path that leads nowhere, or where another one leads, and for the
   * first criteria that no case can have.
   */
  List<Diagnostic> check(Purpose purpose) {
    List<Diagnostic> found = new ArrayList<>();
    ObjectNode copy = scenario.deepCopy();
    Optional<ObjectNode> benchCopy = bench.map(ObjectNode::deepCopy);
    long mark = FIRST_MARK;
    for (Map.Entry<SourceLocation, List<String>> of : paths(plan).entrySet()) {
      for (String path : of.getValue()) {
        Optional<String> wrong =
            path.startsWith(BENCH) && bench.isEmpty()
                ? Optional.of("The project has no bench.yaml for '" + path + "'.")
                : taking(path.startsWith(BENCH) ? benchCopy.orElseThrow() : copy, path, mark++);
        Optional<String> problem = wrong.or(() -> ofNoNode(path));
        problem.ifPresent(it -> found.add(Diagnostic.of(CampaignRules.FACTOR, it, of.getKey())));
      }
    }
    if (found.isEmpty()) {
      found.addAll(ofCriteria(purpose));
    }
    if (!found.isEmpty()) {
      return found;
    }
    return new RefusedValues(plan, this::of, this::pointer).findings();
  }

  /** Returns what is wrong with the criteria of cases, and with those on which points depend. */
  private List<Diagnostic> ofCriteria(Purpose purpose) {
    Optional<SearchSettings.Named> ofBoundary =
        plan.boundary().flatMap(CampaignPlan.Boundary::criterion);
    if (plan.criteria().isEmpty() && plan.points().isEmpty() && ofBoundary.isEmpty()) {
      return List.of();
    }
    try {
      List<CampaignCase> all =
          purpose == Purpose.SEARCH ? new SearchSpace(plan).tried() : new CaseList(plan).cases();
      List<Diagnostic> found =
          new ArrayList<>(criteria.check(all, each -> ofCriteria(each, this::read)));
      if (found.isEmpty()) {
        points.ifPresent(it -> found.addAll(it.check(criteria.kinds(all))));
        ofBoundary.flatMap(it -> ofBoundary(it, all)).ifPresent(found::add);
      }
      return found;
    } catch (DiagnosticException e) {
      return e.diagnostics();
    }
  }

  private Optional<Diagnostic> ofBoundary(SearchSettings.Named named, List<CampaignCase> all) {
    return NamedCriterion.problem(
        CampaignRules.CRITERIA, named, plan.scenario(), textsOfKinds(criteria.kinds(all)));
  }

  /** Returns what is wrong with the criteria of cases that ended by an error because of that. */
  Map<CampaignCase, Diagnostic> ofCriteria(List<CampaignRow> rows) {
    List<CampaignCase> errors =
        rows.stream().filter(row -> row.is(Label.ERROR)).map(CampaignRow::id).toList();
    return criteria.wrong(errors, each -> ofCriteria(each, this::of));
  }

  /** Returns what is wrong with the criteria of a case. */
  private static Optional<Diagnostic> ofCriteria(CampaignCase each, Consumer<CampaignCase> reader) {
    try {
      reader.accept(each);
      return Optional.empty();
    } catch (DiagnosticException e) {
      return e.diagnostics().stream().filter(CriteriaOfCases::isAbout).findFirst();
    }
  }

  /** Returns the problem of a path to a node's phase; in a file, any key names a node. */
  private Optional<String> ofNoNode(String path) {
    String node = path.substring(path.startsWith(PHASE) ? PHASE.length() : 0);
    return path.startsWith(PHASE) && !nodes.contains(node)
        ? Optional.of(
            "The chain has no node '%s'. %s".formatted(node, NearestName.hint(node, nodes)).strip())
        : Optional.empty();
  }

  /** Marks the number of a path; returns what is wrong with the path. */
  private static Optional<String> taking(ObjectNode root, String path, long mark) {
    try {
      NumberPath.Place place = numberPath(path).in(root);
      long before = place.owner().path(place.key()).asLong();
      place.set(BigDecimal.valueOf(mark));
      return before >= FIRST_MARK
          ? Optional.of("Two factors have '" + path + "'.")
          : Optional.empty();
    } catch (NumberPath.WrongPathException e) {
      return Optional.of(e.getMessage());
    }
  }

  private static NumberPath numberPath(String path) {
    return new NumberPath(path.startsWith(BENCH) ? path.substring(BENCH.length()) : path);
  }

  /** Returns the place of a path in its file, as a finding about it has it. */
  private Optional<String> pointer(String path) {
    return (path.startsWith(BENCH) ? bench : Optional.of(scenario))
        .flatMap(root -> numberPath(path).pointer(root));
  }

  /**
   * Returns a case: the scenario, and the bench if a factor is one of its numbers.
   *
   * @throws DiagnosticException (INPUT) if its values do not fit together, or it lacks a criterion
   *     on which its points depend
   */
  CaseSimulation.Case of(CampaignCase each) {
    CaseSimulation.Case own = read(each);
    points.ifPresent(it -> it.require(each, texts(own)));
    return own;
  }

  private CaseSimulation.Case read(CampaignCase each) {
    Bench own = usualBench;
    if (variesBench) {
      ObjectNode copy = bench.orElseThrow().deepCopy();
      setAll(copy, true, each);
      String name = benchFile.orElseThrow().toString();
      own = benches.apply(SourceText.of(name, copy.toPrettyString()));
    }
    return new CaseSimulation.Case(
        cases.read(SourceText.of(file.toString(), text(each)), own), own);
  }

  /** Returns the scenario of a case as JSON, which is YAML, too, for the folder of its file. */
  private String text(CampaignCase each) {
    ObjectNode copy = criteria.with(scenario, each);
    setAll(copy, false, each);
    if (plan.repetitions() > 1) {
      long seed = copy.path("seed").asLong(1);
      copy.set("seed", LongNode.valueOf(seed + each.repetition() - 1));
    }
    return copy.toPrettyString();
  }

  /** Returns the scenario of a case as YAML, for a folder. */
  String text(CampaignCase each, Path folder) {
    return YamlLayout.of(moved(each, folder));
  }

  /** Returns the scenario of a case as YAML, for a folder, under another name and title. */
  String text(CampaignCase each, Path folder, String name, String title) {
    ObjectNode copy = moved(each, folder);
    copy.put("name", name);
    copy.put("title", title);
    return YamlLayout.of(copy);
  }

  /** Returns the scenario of a case, which leads from a folder to the file that it plays. */
  private ObjectNode moved(CampaignCase each, Path folder) {
    ObjectNode copy = tree(SourceText.of(file.toString(), text(each)));
    if (copy.path(PLAYED).path(PLAYED_FILE).isTextual()) {
      Path played = file.resolveSibling(copy.get(PLAYED).get(PLAYED_FILE).textValue());
      ((ObjectNode) copy.get(PLAYED)).put(PLAYED_FILE, path(folder, played));
    }
    return copy;
  }

  /** Returns a path from a folder, so that results do not depend on where a project lies. */
  static String path(Path folder, Path file) {
    Path from = folder.toAbsolutePath().normalize();
    Path to = file.toAbsolutePath().normalize();
    boolean related = from.getRoot().equals(to.getRoot());
    return (related ? from.relativize(to) : to).toString().replace('\\', '/');
  }

  /** Returns the bench of a case as YAML; empty if it is the project's own. */
  Optional<String> bench(CampaignCase each) {
    Optional<ObjectNode> copy = bench.map(ObjectNode::deepCopy);
    copy.ifPresent(it -> setAll(it, true, each));
    return copy.map(YamlLayout::of)
        .filter(text -> !text.equals(YamlLayout.of(bench.orElseThrow())));
  }

  /**
   * Returns the values of the factors in the files as they are written; empty for a factor without
   * a value there, or with several.
   */
  List<Optional<BigDecimal>> usual() {
    ObjectNode copy = scenario.deepCopy();
    Optional<ObjectNode> benchCopy = bench.map(ObjectNode::deepCopy);
    List<Optional<BigDecimal>> usual = new ArrayList<>();
    for (Factor factor : plan.factors()) {
      List<Optional<BigDecimal>> values =
          factor.paths().stream()
              .map(path -> value(path.startsWith(BENCH) ? benchCopy.orElseThrow() : copy, path))
              .distinct()
              .toList();
      usual.add(values.size() == 1 ? values.get(0) : Optional.empty());
    }
    return usual;
  }

  private static Optional<BigDecimal> value(ObjectNode root, String path) {
    try {
      NumberPath.Place place = numberPath(path).in(root);
      JsonNode value = place.owner().path(place.key());
      return value.isNumber()
          ? Optional.of(value.decimalValue().stripTrailingZeros())
          : Optional.empty();
    } catch (NumberPath.WrongPathException e) {
      throw new IllegalStateException("a path that was checked", e);
    }
  }

  private void setAll(ObjectNode root, boolean ofBench, CampaignCase each) {
    plan.settings(each)
        .forEach(
            (path, value) -> {
              if (path.startsWith(BENCH) == ofBench) {
                set(root, path, value);
              }
            });
  }

  private static void set(ObjectNode root, String path, BigDecimal value) {
    try {
      numberPath(path).in(root).set(value);
    } catch (NumberPath.WrongPathException e) {
      throw new IllegalStateException("a path that was checked", e);
    }
  }
}
