package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.run.ScenarioSelection;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** Scenarios of a project that a command is about. */
public final class ProjectScenarios {

  private ProjectScenarios() {}

  /** Returns the scenarios that a run requests, in the order of their files. */
  static List<Scenario> selected(RunContext run) {
    return selected(run, run::find);
  }

  /** Returns the scenarios that a run requests, whose findings are reported elsewhere. */
  public static List<Scenario> read(RunContext run) {
    return FileReads.unrecorded(() -> selected(run, finding -> {}));
  }

  private static List<Scenario> selected(RunContext run, Consumer<Diagnostic> findings) {
    ScenarioSelection selection = run.options().simulation().scenarios();
    if (!selection.files().isEmpty()) {
      return Scenario.readFiles(
          selection.files(), selection.accept(), run.chain().bench(), findings);
    }
    List<Scenario> all =
        Scenario.readFolder(run.project().scenarios(), run.chain().bench(), findings);
    return named(all, selection.names(), run.project().scenarios());
  }

  /**
   * Returns the scenarios of some names, or all if there are none.
   *
   * @param folder that of all scenarios
   * @throws DiagnosticException (INPUT) {@code project.scenario.unknown}
   */
  public static List<Scenario> named(List<Scenario> all, Collection<String> chosen, Path folder) {
    Set<String> wanted = new TreeSet<>(chosen);
    if (wanted.isEmpty()) {
      return all;
    }
    Set<String> names =
        all.stream().map(Scenario::name).collect(Collectors.toCollection(TreeSet::new));
    for (String name : wanted) {
      if (!names.contains(name)) {
        throw new DiagnosticException(
            DiagnosticException.Reason.INPUT,
            Diagnostic.of(
                    SimulateRules.PROJECT_SCENARIO_UNKNOWN,
                    "There is no scenario '" + name + "'.",
                    SourceLocation.of(folder))
                .withHint("The scenarios are " + String.join(", ", names) + "."));
      }
    }
    return all.stream().filter(scenario -> wanted.contains(scenario.name())).toList();
  }
}
