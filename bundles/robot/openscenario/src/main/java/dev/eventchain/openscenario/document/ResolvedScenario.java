package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.Diagnostic;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A scenario whose parameters have their values.
 *
 * @param file the file that it comes from
 * @param root the element {@code OpenSCENARIO}, without declarations of parameters
 * @param parameters the values of the parameters that the file declares, in its order
 * @param variables the first values of the variables likewise
 * @param roadFile the OpenDRIVE file, which exists; empty if the scenario names none
 * @param warnings what to know about the file and about the entries of catalogs that it uses
 */
public record ResolvedScenario(
    ScenarioFile file,
    ScenarioElement root,
    Map<String, String> parameters,
    Map<String, String> variables,
    Optional<Path> roadFile,
    List<Diagnostic> warnings) {

  /** Copies the maps, in their order. */
  public ResolvedScenario {
    parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
    warnings = List.copyOf(warnings);
  }
}
