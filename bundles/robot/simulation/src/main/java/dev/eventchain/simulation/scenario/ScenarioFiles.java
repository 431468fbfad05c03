package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/** Scenarios of files that someone names, also of those in OpenSCENARIO XML without criteria. */
record ScenarioFiles(List<Path> files, List<String> accept) {

  /** The name of what is made of the criteria. */
  private static final String OPTION = "--accept";

  /** Reads the scenarios as {@link Scenario#readFiles} does. */
  List<Scenario> read(Bench bench, Consumer<Diagnostic> warnings) {
    List<Diagnostic> problems = new ArrayList<>();
    List<Scenario> scenarios = new ArrayList<>();
    for (Path file : files) {
      try {
        scenarios.addAll(ScenarioReader.read(text(file), bench, warnings));
      } catch (DiagnosticException e) {
        problems.addAll(e.diagnostics());
      }
    }
    ScenarioFolder.refuseDuplicates(scenarios, problems);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return List.copyOf(scenarios);
  }

  static boolean isOpenScenario(Path file) {
    return file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".xosc");
  }

  private SourceText text(Path file) {
    if (!isOpenScenario(file)) {
      return SourceText.read(file);
    }
    requireAny(file, accept);
    return SourceText.of(
        OPTION, written(file, file.toAbsolutePath().toString(), accept).toPrettyString());
  }

  /**
   * Requires criteria for a file in OpenSCENARIO XML.
   *
   * @throws DiagnosticException (INPUT) if there are none
   */
  static void requireAny(Path file, List<String> accept) {
    if (accept.isEmpty()) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  ScenarioRules.KEY_MISSING,
                  "An OpenSCENARIO file does not say what is required of the software.",
                  SourceLocation.of(file))
              .withHint(
                  "Add --accept no_impact or another criterion, or write a scenario with"
                      + " `openscenario: {file: "
                      + file.getFileName()
                      + "}` and `accept`."));
    }
  }

  /**
   * Returns a scenario that plays a file in OpenSCENARIO XML.
   *
   * @param path of the file, as the scenario names it
   * @param accept what is required: {@code KEY} or {@code KEY=NUMBER} each
   */
  static ObjectNode written(Path file, String path, List<String> accept) {
    ObjectNode scenario = JsonNodeFactory.instance.objectNode();
    String base = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    scenario.put("name", nameOf(file));
    scenario.put("title", base);
    scenario.putObject(OpenScenarioReader.KEY).put("file", path);
    ObjectNode criteria = scenario.putObject("accept");
    accept.forEach(each -> put(criteria, each));
    return scenario;
  }

  /** Returns the name of a scenario that plays a file. */
  static String nameOf(Path file) {
    return file.getFileName()
        .toString()
        .replaceFirst("\\.[^.]*$", "")
        .toLowerCase(Locale.ROOT)
        .replaceAll("[^a-z0-9]+", "-")
        .replaceAll("^-|-$", "");
  }

  /** Adds {@code KEY} or {@code KEY=NUMBER}. */
  private static void put(ObjectNode criteria, String written) {
    int equals = written.indexOf('=');
    if (equals < 0) {
      criteria.put(written, true);
      return;
    }
    String value = written.substring(equals + 1);
    try {
      criteria.put(written.substring(0, equals), new BigDecimal(value));
    } catch (NumberFormatException e) {
      criteria.put(written.substring(0, equals), value);
    }
  }
}
