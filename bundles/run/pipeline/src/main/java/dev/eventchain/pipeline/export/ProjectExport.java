package dev.eventchain.pipeline.export;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.ProjectBench;
import dev.eventchain.pipeline.files.WrittenFiles;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.simulate.ProjectScenarios;
import dev.eventchain.simulation.export.ScenarioExport;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Scenarios of a project as OpenSCENARIO XML on OpenDRIVE roads. */
public final class ProjectExport {

  private static final String PRODUCER = "export";

  private ProjectExport() {}

  /**
   * Writes {@code NAME.xosc} and {@code NAME.xodr} for each scenario that can be said in the
   * formats. Files that an earlier export wrote for one that cannot are removed, and if all
   * scenarios are exported, those of former ones, too.
   *
   * @param chosen the names of the scenarios; empty for all
   * @param onEdit what becomes of files that a person has edited
   * @return the findings, with the reason for each scenario that is not written
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read, a
   *     scenario is unknown, or the output cannot be written
   */
  public static WrittenFiles write(
      Project project, Collection<String> chosen, Path folder, OnEdit onEdit) {
    List<Diagnostic> found = new ArrayList<>();
    List<Scenario> all =
        Scenario.readFolder(project.scenarios(), ProjectBench.read(project), found::add);
    List<Scenario> wanted = ProjectScenarios.named(all, chosen, project.scenarios());
    String software = project.configuration().settings().name();
    Map<String, byte[]> files = new TreeMap<>();
    List<String> refused = new ArrayList<>();
    for (Scenario scenario : wanted) {
      ScenarioExport export = ScenarioExport.of(scenario, software);
      found.addAll(export.diagnostics());
      files.putAll(export.files());
      if (export.files().isEmpty()) {
        refused.add(scenario.name());
      }
    }
    WrittenFiles written = new WrittenFiles(Optional.of(folder));
    written.found(found);
    try (OutputFolder output = OutputFolder.open(folder)) {
      output.damage().ifPresent(it -> written.found(List.of(it)));
      written.write(output, files, onEdit);
      written.found(removed(output, refused));
      if (chosen.isEmpty()) {
        written.found(output.removeFormer(PRODUCER, files.keySet()));
      }
    }
    return written;
  }

  /** Removes what an earlier export wrote for scenarios; returns a finding where it cannot. */
  private static List<Diagnostic> removed(OutputFolder output, List<String> names) {
    List<Diagnostic> kept = new ArrayList<>();
    for (String name : names) {
      kept.addAll(output.removeOthers(name + ".xosc", List.of()));
      kept.addAll(output.removeOthers(name + ".xodr", List.of()));
    }
    return kept;
  }
}
