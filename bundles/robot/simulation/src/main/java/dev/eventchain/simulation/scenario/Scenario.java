package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.BenchReader;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.stage.PlayedFiles;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A situation on the road with the criteria for the software. Read from a YAML file, whose content
 * alone determines the physics, the noise and the phases of the nodes. Immutable.
 */
public final class Scenario {

  private final long seed;
  private final double duration;
  private final Situation situation;
  private final Map<String, Script> inputs;
  private final NodePhases phases;
  private final Asked asked;
  private final Heading heading;

  Scenario(
      Heading heading,
      long seed,
      double duration,
      Situation situation,
      Map<String, Script> inputs,
      NodePhases phases,
      Asked asked) {
    this.heading = heading;
    this.seed = seed;
    this.duration = duration;
    this.situation = situation;
    this.inputs = Map.copyOf(inputs);
    this.phases = phases;
    this.asked = asked;
  }

  /**
   * Names and requirements of a scenario.
   *
   * @param parts returns the locations of its parts by their pointers
   * @param end the location of what ends it before its time; empty if nothing does
   */
  record Heading(
      String name,
      String title,
      String description,
      List<String> requirements,
      NamedRequirements.Places places,
      Function<String, SourceLocation> parts,
      Optional<SourceLocation> end) {

    /** Copies the list. */
    Heading {
      requirements = List.copyOf(requirements);
    }
  }

  /** Returns a copy with other criteria. */
  public Scenario with(List<Expectation> others) {
    Asked other =
        new Asked(others, asked.conditions(), asked.observed(), asked.judged(), asked.optional());
    return new Scenario(heading, seed, duration, situation, inputs, phases, other);
  }

  /**
   * Returns a copy without the criteria that a run of it did not ask.
   *
   * @param unasked their locations
   */
  public Scenario without(Set<SourceLocation> unasked) {
    return with(
        asked.criteria().stream().filter(each -> !unasked.contains(each.location())).toList());
  }

  /** Returns the words of requirements that its criteria judge, in their order. */
  public List<JudgedWords> judged() {
    return asked.judged();
  }

  /** Returns the words of requirements that a criterion judges, in their order. */
  public List<ScenarioVerdict.Judged> judgedBy(Expectation criterion) {
    return asked.judged().stream()
        .filter(each -> each.criterion().equals(criterion.location()))
        .map(each -> new ScenarioVerdict.Judged(each.requirement(), each.words()))
        .toList();
  }

  /** Returns what makes a run the test that is described: where one fails, nothing is judged. */
  public List<Expectation> conditions() {
    return asked.conditions();
  }

  /** Returns the formulas that are reported, and not judged. */
  public List<Expectation> observed() {
    return asked.observed();
  }

  /**
   * Returns a finding {@code scenario.output.unresolved} for each criterion on an output of which
   * the chain has none or several.
   */
  public List<Diagnostic> unresolved() {
    return Stream.concat(asked.criteria().stream(), asked.conditions().stream())
        .filter(each -> each instanceof UnresolvedCriterion && !isOptional(each))
        .map(each -> ((UnresolvedCriterion) each).finding())
        .toList();
  }

  /**
   * Returns whether a criterion is on something to which correct software need not come: it is not
   * asked where that does not come.
   */
  public boolean isOptional(Expectation criterion) {
    return asked.optional().contains(criterion.location());
  }

  /**
   * Reads one scenario.
   *
   * @param bench the inputs that it may set, and the signals that its formulas may read
   * @throws DiagnosticException (INPUT) with every problem of the file: {@code scenario.syntax},
   *     {@code scenario.key.unknown}, {@code scenario.key.duplicate}, {@code scenario.key.missing},
   *     {@code scenario.value.type}, {@code scenario.value.range}, {@code scenario.formula.syntax},
   *     {@code scenario.formula.unit}, {@code scenario.formula.signal}, {@code
   *     scenario.input.unknown}, or that it cannot be read
   */
  public static Scenario read(Path file, Bench bench) {
    return parse(SourceText.read(file), bench);
  }

  /**
   * Reads one scenario likewise.
   *
   * @param warnings receives what to know about other files to which it leads
   */
  public static Scenario read(Path file, Bench bench, Consumer<Diagnostic> warnings) {
    return ScenarioReader.readOnly(SourceText.read(file), bench, true, new PlayedFiles(), warnings);
  }

  /** Reads a text in memory as {@link #read} does. */
  public static Scenario parse(SourceText text, Bench bench) {
    return ScenarioReader.readOnly(text, bench, true, new PlayedFiles(), warning -> {});
  }

  /**
   * Reads the YAML files of a folder and those below it, in the order of their paths.
   *
   * @param bench as for {@link #read}
   * @param warnings receives findings on other YAML files ({@code scenario.file.unread})
   * @throws DiagnosticException (INPUT) with every problem of every file; also if there is no such
   *     folder or no scenario in it ({@code scenario.none}), or if two scenarios have one name
   *     ({@code scenario.name.duplicate})
   */
  public static List<Scenario> readFolder(Path folder, Bench bench, Consumer<Diagnostic> warnings) {
    return new ScenarioFolder(folder).read(bench, warnings);
  }

  /**
   * Reads the scenarios of files, in their order.
   *
   * @param accept the criteria of files in OpenSCENARIO XML: {@code KEY} or {@code KEY=NUMBER}
   * @param warnings receives what to know about the files
   * @throws DiagnosticException (INPUT) with every problem of every file, or if two scenarios have
   *     one name
   */
  public static List<Scenario> readFiles(
      List<Path> files, List<String> accept, Bench bench, Consumer<Diagnostic> warnings) {
    return new ScenarioFiles(files, accept).read(bench, warnings);
  }

  /** Returns the JSON Schema of scenarios. */
  public static String schema() {
    return BenchReader.resource("scenario.schema.json");
  }

  /**
   * Returns the files in a folder of scenarios, in a fixed order, and then those outside of it to
   * which scenarios lead.
   */
  public static List<Path> filesIn(Path folder) {
    return new ScenarioFolder(folder).allFiles();
  }

  /** Returns a file with scenarios, and those to which it leads, in a fixed order. */
  public static List<Path> filesOf(Path file) {
    return ScenarioFolder.withPlayed(List.of(file));
  }

  /** Returns the name, unique in a folder: lower-case letters, digits and hyphens. */
  public String name() {
    return heading.name();
  }

  /** Returns the title for users. */
  public String title() {
    return heading.title();
  }

  /** Returns what it says about itself for users, on one line; may be empty. */
  public String description() {
    return heading.description();
  }

  /** Returns the ids of all requirements that it or one of its criteria names. */
  public List<String> requirements() {
    return heading.requirements();
  }

  /** Returns the location of the requirements; the whole scenario if there are none. */
  public SourceLocation requirementsLocation() {
    return heading.places().list();
  }

  /** Returns the location where a requirement is named first. */
  public SourceLocation locationOf(String requirement) {
    NamedRequirements.Places places = heading.places();
    return places.of().getOrDefault(requirement, places.list());
  }

  /** Returns the location of the scenario. */
  public SourceLocation location() {
    return locationOfPart("");
  }

  /**
   * Returns the location of a part; of a case, that of the scenario.
   *
   * @param pointer such as {@code /actors/0}
   */
  public SourceLocation locationOfPart(String pointer) {
    return heading.parts().apply(pointer);
  }

  /**
   * Returns the location of what ended a run at a time that no impact ended: the duration, or what
   * of an OpenSCENARIO file may end it before.
   *
   * @param time in ns
   */
  public SourceLocation endLocation(long time) {
    return heading
        .end()
        .filter(end -> time < World.nanoseconds(duration))
        .orElseGet(() -> locationOfPart("/duration_s"));
  }

  /** Returns the maximum simulated time, in s. */
  public double duration() {
    return duration;
  }

  public long seed() {
    return seed;
  }

  /** Returns the vehicle, driver, road and all actors at the start. */
  public Situation situation() {
    return situation;
  }

  /** Returns the scripts for the inputs of the bench, by their names. */
  public Map<String, Script> inputs() {
    return inputs;
  }

  /** Returns the phases that it sets, in ms, by the names of the nodes. */
  public Map<String, Double> phases() {
    return phases.milliseconds();
  }

  /**
   * Returns a finding {@code scenario.node.unknown} for each node whose phase it sets and that the
   * chain does not have.
   *
   * @param nodes the names of the chain's nodes
   */
  public List<Diagnostic> unknownNodes(Collection<String> nodes) {
    return phases.unknown(nodes);
  }

  /**
   * Returns the names of the signals that the criteria of a requirement read, {@code /topic.field}
   * for fields of topics.
   */
  public Set<String> reads(String requirement) {
    return criteriaOf(requirement)
        .flatMap(each -> each.signals().stream())
        .map(Signal::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * Returns whether a criterion of a requirement depends on the messages on some topics: it reads a
   * field of one or, if one of them commands the vehicle, the motion of the vehicle.
   *
   * @param topics full names
   */
  public boolean dependsOn(String requirement, Set<String> topics, Bench bench) {
    boolean commanding = isCommanded(topics, bench);
    return criteriaOf(requirement).anyMatch(each -> each.dependsOn(topics, commanding));
  }

  /** As {@link #dependsOn(String, Set, Bench)}, for the criterion at a location. */
  public boolean dependsOn(SourceLocation criterion, Set<String> topics, Bench bench) {
    boolean commanding = isCommanded(topics, bench);
    return criteria().stream()
        .filter(each -> each.location().equals(criterion))
        .anyMatch(each -> each.dependsOn(topics, commanding));
  }

  private static boolean isCommanded(Set<String> topics, Bench bench) {
    return bench.consumed().values().stream()
        .filter(Bench.Consumed::commands)
        .anyMatch(topic -> topics.contains(topic.topic()));
  }

  private Stream<Expectation> criteriaOf(String requirement) {
    return criteria().stream().filter(each -> each.requirements().contains(requirement));
  }

  /** Returns the signals that its formulas read, also those that are only reported. */
  public Set<Signal> signals() {
    return Stream.of(asked.criteria(), asked.conditions(), asked.observed())
        .flatMap(List::stream)
        .flatMap(each -> each.signals().stream())
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /** Returns whether a criterion says how fast an impact may be, so that one may end a run. */
  public boolean allowsImpact() {
    return criteria().stream().anyMatch(each -> isOf(each, CriterionKind.MAXIMAL_IMPACT_SPEED));
  }

  /** Returns whether a criterion is about impacts, so that none goes unnoticed. */
  public boolean judgesImpact() {
    return allowsImpact()
        || criteria().stream()
            .anyMatch(
                each -> isOf(each, CriterionKind.NO_IMPACT) || isOf(each, CriterionKind.STOPS));
  }

  private static boolean isOf(Expectation expectation, CriterionKind kind) {
    return expectation instanceof Criterion criterion && criterion.kind() == kind;
  }

  /** Returns the end of the part of a run that the criteria need without an impact, in ns. */
  public long horizon() {
    long longest = World.nanoseconds(duration);
    Stream<Expectation> all = Stream.concat(asked.criteria().stream(), asked.conditions().stream());
    return Math.min(longest, all.mapToLong(Expectation::horizon).max().orElse(0));
  }

  public List<Expectation> criteria() {
    return asked.criteria();
  }
}
