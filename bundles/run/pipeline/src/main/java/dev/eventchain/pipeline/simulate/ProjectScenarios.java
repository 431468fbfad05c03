package dev.eventchain.pipeline.simulate;

import dev.eventchain.check.CheckRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Scenarios of a project, and the requirements that they test. */
public final class ProjectScenarios {

  private ProjectScenarios() {}

  /**
   * Reads bench and scenarios before any language model is asked: otherwise unreadable scenarios or
   * unknown requirements would be found only after the cost.
   *
   * @return the findings about the requirements that the scenarios name
   * @throws DiagnosticException INPUT if the bench or a scenario cannot be read
   */
  public static List<Diagnostic> check(RunContext run) {
    List<Scenario> scenarios =
        Scenario.readFolder(run.project().scenarios(), run.bench(), warning -> {});
    List<String> known = run.writtenRequirements().stream().map(WrittenRequirement::id).toList();
    List<Diagnostic> found = new ArrayList<>();
    if (known.isEmpty()) {
      return found;
    }
    found.addAll(run.requirements().diagnostics());
    for (Scenario scenario : scenarios) {
      if (scenario.requirements().isEmpty()) {
        found.add(unrelated(scenario));
      }
      scenario.requirements().stream()
          .filter(id -> !known.contains(id))
          .map(id -> unknown(scenario, id, known))
          .forEach(found::add);
    }
    return found;
  }

  private static Diagnostic unrelated(Scenario scenario) {
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_UNKNOWN,
            "The scenario '" + scenario.name() + "' names no requirement, so it proves none.",
            scenario.requirementsLocation())
        .withSeverity(Severity.WARNING)
        .withHint("Name those that it tests: requirements: [ID, ...]");
  }

  private static Diagnostic unknown(Scenario scenario, String id, List<String> known) {
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_UNKNOWN,
            "The scenario '%s' tests '%s', which is not a requirement of this project."
                .formatted(scenario.name(), id),
            scenario.locationOf(id))
        .withHint(NearestName.question(id, known));
  }

  /** Returns the scenarios that a run requests, in the order of their files. */
  static List<Scenario> selected(RunContext run) {
    List<Scenario> all = Scenario.readFolder(run.project().scenarios(), run.bench(), run::find);
    Set<String> wanted = new TreeSet<>(run.options().scenarios());
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
                    SourceLocation.of(run.project().scenarios()))
                .withHint("The scenarios are " + String.join(", ", names) + "."));
      }
    }
    return all.stream().filter(scenario -> wanted.contains(scenario.name())).toList();
  }
}
