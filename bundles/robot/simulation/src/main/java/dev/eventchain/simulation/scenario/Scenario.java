package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.BenchReader;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * A situation on the road with the criteria that the software must meet in it. Read from a YAML
 * file; the physics, the noise and the phases of the nodes follow from its content alone.
 * Immutable.
 */
public final class Scenario {

  private final String name;
  private final String title;
  private final String description;
  private final List<String> requirements;
  private final long seed;
  private final double duration;
  private final Situation situation;
  private final Map<String, Script> inputs;
  private final List<Expectation> criteria;
  private final SourceLocation requirementsLocation;
  private final SourceLocation location;

  Scenario(
      Heading heading,
      long seed,
      double duration,
      Situation situation,
      Map<String, Script> inputs,
      List<Expectation> criteria) {
    this.name = heading.name();
    this.title = heading.title();
    this.description = heading.description();
    this.requirements = List.copyOf(heading.requirements());
    this.requirementsLocation = heading.requirementsLocation();
    this.location = heading.location();
    this.seed = seed;
    this.duration = duration;
    this.situation = situation;
    this.inputs = Map.copyOf(inputs);
    this.criteria = List.copyOf(criteria);
  }

  /** What people read of a scenario. */
  record Heading(
      String name,
      String title,
      String description,
      List<String> requirements,
      SourceLocation requirementsLocation,
      SourceLocation location) {}

  /** The same with other criteria. */
  public Scenario with(List<Expectation> others) {
    Heading heading =
        new Heading(name, title, description, requirements, requirementsLocation, location);
    return new Scenario(heading, seed, duration, situation, inputs, others);
  }

  /**
   * Reads one scenario.
   *
   * @param bench what inputs it may set, and what its formulas may read
   * @throws DiagnosticException (INPUT) with every problem of the file: {@code scenario.syntax},
   *     {@code scenario.key.unknown}, {@code scenario.key.duplicate}, {@code scenario.key.missing},
   *     {@code scenario.value.type}, {@code scenario.value.range}, {@code scenario.formula.syntax},
   *     {@code scenario.formula.unit}, {@code scenario.formula.signal}, {@code
   *     scenario.input.unknown}, or that it cannot be read
   */
  public static Scenario read(Path file, Bench bench) {
    return parse(SourceText.read(file), bench);
  }

  /** As {@link #read} for a text that is in memory already. */
  public static Scenario parse(SourceText text, Bench bench) {
    return ScenarioReader.read(text, bench);
  }

  /**
   * Reads the YAML files of a folder and those below it, in the order of their paths.
   *
   * @param bench as for {@link #read}
   * @param warnings gets the files that are none ({@code scenario.file.unread})
   * @throws DiagnosticException (INPUT) with every problem of every file; also if there is no such
   *     folder or no scenario in it ({@code scenario.none}), or if two scenarios have one name
   *     ({@code scenario.name.duplicate})
   */
  public static List<Scenario> readFolder(Path folder, Bench bench, Consumer<Diagnostic> warnings) {
    return new ScenarioFolder(folder).read(bench, warnings);
  }

  /** The JSON Schema of scenarios. */
  public static String schema() {
    return BenchReader.resource("scenario.schema.json");
  }

  /** The files on which {@link #readFolder} depends, in a fixed order. */
  public static List<Path> filesIn(Path folder) {
    return new ScenarioFolder(folder).files();
  }

  /** The name, unique in a folder: lower-case letters, digits and hyphens. */
  public String name() {
    return name;
  }

  /** A title for people. */
  public String title() {
    return title;
  }

  /** What happens in it and why it is there; may be empty. */
  public String description() {
    return description;
  }

  /** Ids of the requirements that it tests. */
  public List<String> requirements() {
    return requirements;
  }

  /** Where it names the requirements; the whole of it if it names none. */
  public SourceLocation requirementsLocation() {
    return requirementsLocation;
  }

  /** Where it was read from. */
  public SourceLocation location() {
    return location;
  }

  /** The longest simulated time, in s. */
  public double duration() {
    return duration;
  }

  public long seed() {
    return seed;
  }

  /** Vehicle, driver, road and all others at the start. */
  public Situation situation() {
    return situation;
  }

  /** What people do with the inputs of the bench, by their names. */
  public Map<String, Script> inputs() {
    return inputs;
  }

  /** The names of the signals that its criteria read, {@code /topic.field} for those of topics. */
  public Set<String> reads() {
    return signals().stream().map(Signal::name).collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * Whether one of its criteria depends on what is written on some topics: it reads a field of one,
   * or, where one of them commands the vehicle, what the vehicle does.
   *
   * @param topics full names
   */
  public boolean dependsOn(Set<String> topics, Bench bench) {
    boolean commanding =
        bench.consumed().values().stream()
            .filter(Bench.Consumed::commands)
            .anyMatch(topic -> topics.contains(topic.topic()));
    return criteria.stream().anyMatch(each -> each.dependsOn(topics, commanding));
  }

  /** The signals that its formulas read. */
  public Set<Signal> signals() {
    return criteria.stream()
        .flatMap(each -> each.signals().stream())
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /** Until when the criteria need a run that no impact ends, in ns. */
  public long horizon() {
    return criteria.stream().mapToLong(Expectation::horizon).max().orElse(0);
  }

  public List<Expectation> criteria() {
    return criteria;
  }
}
