package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import dev.eventchain.simulation.stage.PlayedFile;
import dev.eventchain.simulation.stage.PlayedFiles;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the section {@code openscenario} of a scenario: the file that has its situation. */
final class OpenScenarioReader {

  /** The key of the section. */
  static final String KEY = "openscenario";

  /** The key of which side positions on routes mean. */
  private static final String ROUTE_POSITIONS = "route_positions";

  /** Keys that the file replaces, so that the scenario may not have them. */
  static final List<String> ELSEWHERE = List.of("road", "actors", "furniture");

  private OpenScenarioReader() {}

  /**
   * Returns what is played, one for each case of a distribution; empty if the section or a file is
   * wrong.
   *
   * @param scenario the whole scenario
   * @param file its file, from whose folder paths go
   * @param files what was read before
   */
  static List<PlayedFile> read(ObjectReader scenario, Path file, PlayedFiles files) {
    Optional<ObjectReader> section = scenario.requiredObject(KEY);
    for (String key : ELSEWHERE) {
      if (scenario.has(key)) {
        scenario.value(key);
        scenario.find(
            Diagnostic.of(
                    ScenarioRules.KEY_UNKNOWN,
                    "'" + key + "' is that of the OpenSCENARIO file.",
                    scenario.atKey(key))
                .withHint("Leave it out, or describe all of the situation here."));
      }
    }
    return section.map(part -> played(part, file, files)).orElse(List.of());
  }

  /** Reads the files to which a scenario leads, as far as they can be read. */
  static void visit(ObjectReader scenario, Path file) {
    scenario
        .object(KEY)
        .ifPresent(
            part -> {
              String played = part.requiredText("file");
              if (!played.isBlank()) {
                PlayedFile.visit(
                    file.resolveSibling(played), parametersOf(part), new PlayedFiles());
              }
            });
  }

  private static Map<String, String> parametersOf(ObjectReader section) {
    return section.object("parameters").map(OpenScenarioReader::parameters).orElse(Map.of());
  }

  private static List<PlayedFile> played(ObjectReader section, Path scenario, PlayedFiles files) {
    String file = section.requiredText("file");
    Optional<String> ego = section.text("ego");
    Map<String, String> parameters = parametersOf(section);
    Optional<String> written = section.text(ROUTE_POSITIONS);
    Optional<RouteSides> routeSides = written.flatMap(RouteSides::of);
    if (written.isPresent() && routeSides.isEmpty()) {
      section.refuseType(ROUTE_POSITIONS, "`road` or `route`");
    }
    section.refuseOthers();
    if (file.isBlank()) {
      return List.of();
    }
    try {
      return PlayedFile.read(
          scenario.resolveSibling(file),
          new PlayedFile.Choices(parameters, ego, routeSides),
          section.at("file"),
          files);
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(section::find);
      return List.of();
    }
  }

  private static Map<String, String> parameters(ObjectReader section) {
    Map<String, String> parameters = new LinkedHashMap<>();
    for (String name : section.names()) {
      Optional<JsonNode> value = section.value(name);
      if (value.filter(JsonNode::isValueNode).isEmpty()) {
        section.refuseType(name, "a text, a number or a Boolean");
      }
      value.ifPresent(
          it ->
              parameters.put(
                  name, it.isNumber() ? it.decimalValue().toPlainString() : it.asText()));
    }
    return parameters;
  }
}
