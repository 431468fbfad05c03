package dev.eventchain.pipeline.run;

import java.nio.file.Path;
import java.util.List;

/**
 * The scenarios that a run simulates: some of the project's, or those of other files.
 *
 * @param names of scenarios of the project; empty: all of them, unless there are files
 * @param files with scenarios, of this project's format or in OpenSCENARIO XML
 * @param accept criteria for those in OpenSCENARIO XML, which have none: {@code KEY} or {@code
 *     KEY=NUMBER}, with the keys of {@code accept} in a scenario
 */
public record ScenarioSelection(List<String> names, List<Path> files, List<String> accept) {

  /** All scenarios of the project. */
  public static final ScenarioSelection ALL =
      new ScenarioSelection(List.of(), List.of(), List.of());

  /** Copies the lists. */
  public ScenarioSelection {
    names = List.copyOf(names);
    files = List.copyOf(files);
    accept = List.copyOf(accept);
  }

  /** Returns whether all scenarios of the project are simulated, and no others. */
  public boolean isAll() {
    return names.isEmpty() && files.isEmpty();
  }
}
