package dev.eventchain.pipeline.simulate;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.UnifiedDiff;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.SimulationOptions.Driver;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.Measurements;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Execution times of a run in real time that are longer than the worst cases that components state,
 * with a change of {@code components.json} that states them. Nothing is changed here: a time that
 * was measured on this machine is no bound, and only who knows the vehicle's can decide.
 */
public final class MeasuredTimes {

  /** The file of the proposed change, among the results. */
  public static final String DIFF = "measured-times.diff";

  private static final String KEY = ChainNames.WORST_CASE_EXECUTION_TIME;
  private static final Pattern NUMBER = Pattern.compile("-?[0-9][0-9.eE+-]*");
  private static final int DECIMALS = 2;

  private final String name;
  private final SourceText source;
  private final Document document;
  private final Map<String, BigDecimal> longest = new LinkedHashMap<>();
  private final List<Diagnostic> findings = new ArrayList<>();

  /** New texts by the offsets at which they begin, each with the length that it replaces. */
  private final TreeMap<Integer, Edit> edits = new TreeMap<>();

  private record Edit(int length, String text) {}

  /**
   * Compares times with what is stated.
   *
   * @param name the name of the file in the project, for the diff
   * @param source the description of the existing components
   * @param longest the longest measured times, in ms, by component
   */
  MeasuredTimes(String name, SourceText source, Map<String, Double> longest) {
    this.name = name;
    this.source = source;
    this.document = JsonDocument.parse(source);
    longest.forEach((node, time) -> this.longest.put(node, BigDecimal.valueOf(time)));
    for (int i = 0; i < document.root().size(); i++) {
      compare(Document.below("", i), document.root().get(i));
    }
  }

  /**
   * Writes the change that a run in real time proposes, if it does, and removes an earlier one.
   *
   * @return the findings about times that are longer than stated
   */
  static List<Diagnostic> propose(RunContext run, SimulationResult result) {
    run.output().removeAll(DIFF);
    if (run.options().simulation().driver() != Driver.DDS_IN_REAL_TIME) {
      return List.of();
    }
    Map<String, Double> longest = new LinkedHashMap<>();
    for (Measurements.Node node : result.measurements().nodes()) {
      node.hostExecutionTime().ifPresent(time -> longest.put(node.name(), time.maximum()));
    }
    Optional<MeasuredTimes> times = of(run.project(), longest);
    times
        .flatMap(MeasuredTimes::diff)
        .ifPresent(text -> run.writeResult(DIFF, text.getBytes(StandardCharsets.UTF_8)));
    return times.map(MeasuredTimes::findings).orElse(List.of());
  }

  /**
   * Compares times with what the existing components of a project state.
   *
   * @param longest the longest measured times, in ms, by component
   * @return empty if the project has no description of existing components
   */
  public static Optional<MeasuredTimes> of(Project project, Map<String, Double> longest) {
    Path file = project.componentsFile();
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    String name = project.folder().relativize(file).toString().replace('\\', '/');
    return Optional.of(new MeasuredTimes(name, SourceText.read(file), longest));
  }

  private static String up(BigDecimal milliseconds) {
    return milliseconds
        .setScale(DECIMALS, RoundingMode.CEILING)
        .stripTrailingZeros()
        .toPlainString();
  }

  private void compare(String pointer, JsonNode component) {
    String node = component.path("name").asText();
    BigDecimal measured = longest.get(node);
    JsonNode stated = component.path(KEY);
    if (measured == null) {
      return;
    }
    if (stated.isMissingNode()) {
      SourceLocation place = document.atKey(Document.below(pointer, "name"));
      add(source.offset(place.line(), place.column()), measured);
      found(node, measured, "and it states no worst case", place);
    } else if (stated.isNumber() && measured.compareTo(stated.decimalValue()) > 0) {
      SourceLocation place = document.at(Document.below(pointer, KEY));
      replace(source.offset(place.line(), place.column()), measured);
      found(node, measured, "longer than its worst case of " + stated.asText() + " ms", place);
    }
  }

  private void replace(int offset, BigDecimal measured) {
    Matcher number = NUMBER.matcher(source.text()).region(offset, source.text().length());
    if (number.lookingAt()) {
      edits.put(offset, new Edit(number.end() - offset, up(measured)));
    }
  }

  /** Adds the property before that of the name, on a line of its own if that has one. */
  private void add(int offset, BigDecimal measured) {
    int line = Math.max(source.text().lastIndexOf('\n', offset - 1), -1) + 1;
    String before = source.text().substring(line, offset);
    String next = before.isBlank() ? lineEnd() + before : " ";
    String property = "\"" + KEY + "\": " + up(measured) + ",";
    edits.put(offset, new Edit(0, property + next));
  }

  private String lineEnd() {
    return source.text().contains("\r\n") ? "\r\n" : "\n";
  }

  private void found(String node, BigDecimal measured, String stated, SourceLocation place) {
    String message =
        "'%s' took up to %s ms on this machine, %s.".formatted(node, up(measured), stated);
    findings.add(
        Diagnostic.of(SimulateRules.SIMULATION_TIME_MEASURED, message, place)
            .withHint(
                DIFF
                    + " among the results states the measured times. They are no bounds: add what the vehicle's computer and its load may cost."));
  }

  /** Returns a finding for each component that took longer than it states, or states nothing. */
  List<Diagnostic> findings() {
    return findings;
  }

  /** Returns the change in the unified format, as {@code patch -p1} takes it; empty for none. */
  public Optional<String> diff() {
    if (edits.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(UnifiedDiff.of(name, Optional.of(source.text()), changed()));
  }

  private String changed() {
    StringBuilder changed = new StringBuilder(source.text());
    edits
        .descendingMap()
        .forEach((at, edit) -> changed.replace(at, at + edit.length(), edit.text()));
    return changed.toString();
  }
}
