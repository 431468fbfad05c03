package dev.eventchain.pipeline.stage;

import dev.eventchain.check.CheckRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Checks of the inputs that a simulation needs besides a valid chain: requirements, bench,
 * scenarios and faults. A run makes them before it simulates, and a validation makes them without a
 * simulation.
 */
public final class SimulationInputs {

  private final RunContext run;
  private final List<Diagnostic> found = new ArrayList<>();

  private SimulationInputs(RunContext run) {
    this.run = run;
  }

  /**
   * Reads requirements, bench and scenarios before any language model is asked: otherwise
   * unreadable scenarios or unknown requirements would be found only after the cost.
   *
   * @return the findings about the requirements that the scenarios name
   * @throws DiagnosticException INPUT if the bench, a scenario or the accepted texts cannot be read
   */
  public static List<Diagnostic> check(RunContext run) {
    run.project().accepted();
    return named(run, scenarios(run, false, warning -> {}));
  }

  /**
   * Checks everything for a validation, and goes on after an error. A part whose own input has an
   * error is left out, since its findings would be consequences.
   *
   * @param valid true if the chain has no error, so that bench and faults can be compared with it
   * @return all findings; those of {@link #check} and {@link #connections} among them
   */
  public static List<Diagnostic> all(RunContext run, boolean valid) {
    SimulationInputs inputs = new SimulationInputs(run);
    boolean bench = inputs.of(run::bench).isPresent();
    Optional<List<Scenario>> scenarios =
        bench ? inputs.of(() -> scenarios(run, valid, inputs.found::add)) : Optional.empty();
    inputs.of(run.project()::accepted);
    scenarios.flatMap(all -> inputs.of(() -> named(run, all))).ifPresent(inputs.found::addAll);
    if (bench && valid) {
      inputs.of(() -> connections(run)).ifPresent(inputs.found::addAll);
      scenarios.ifPresent(inputs::faults);
    }
    return inputs.found.stream().distinct().toList();
  }

  /**
   * Returns the findings about connections between the chain and the bench.
   *
   * @throws DiagnosticException INPUT if the model or the bench cannot be read
   */
  public static List<Diagnostic> connections(RunContext run) {
    return run.bench().check(run.chain().chain(), run.chain()::locate);
  }

  private static List<Scenario> scenarios(
      RunContext run, boolean withChain, Consumer<Diagnostic> warnings) {
    Bench bench = withChain ? run.chain().bench() : run.bench();
    List<Scenario> scenarios = Scenario.readFolder(run.project().scenarios(), bench, warnings);
    if (withChain) {
      scenarios.forEach(each -> each.unresolved().forEach(warnings));
      unknownNodes(run, scenarios).forEach(warnings);
    }
    return scenarios;
  }

  /**
   * Returns a finding for each node whose phase a scenario sets and that the chain does not have.
   */
  public static List<Diagnostic> unknownNodes(RunContext run, List<Scenario> scenarios) {
    List<String> nodes =
        run.chain().chain().getSoftware().stream().map(node -> node.getName()).toList();
    return scenarios.stream().flatMap(each -> each.unknownNodes(nodes).stream()).toList();
  }

  private static List<Diagnostic> named(RunContext run, List<Scenario> scenarios) {
    List<String> known = run.writtenRequirements().stream().map(WrittenRequirement::id).toList();
    List<Diagnostic> found = new ArrayList<>();
    if (known.isEmpty()) {
      run.project().missingRequirements(namedBy(scenarios)).ifPresent(found::add);
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
    found.addAll(JudgedRequirements.check(scenarios, run.writtenRequirements()));
    found.addAll(UnjudgedNumbers.check(scenarios, run.writtenRequirements()));
    return found;
  }

  private static List<String> namedBy(List<Scenario> scenarios) {
    return scenarios.stream().flatMap(each -> each.requirements().stream()).toList();
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

  /** Reads the faults of the options, and those in the project's own file. */
  private void faults(List<Scenario> scenarios) {
    List<Path> files = new ArrayList<>(run.options().simulation().faults().stream().toList());
    run.project().faults().ifPresent(files::add);
    for (Path file : files) {
      of(() -> FaultPlan.read(file, run.chain().chain(), run.bench(), scenarios));
    }
  }

  /** Returns the result of some work; empty if it fails, after collecting its findings. */
  private <T> Optional<T> of(Supplier<T> work) {
    try {
      return Optional.of(work.get());
    } catch (DiagnosticException e) {
      if (e.reason() == DiagnosticException.Reason.UNAVAILABLE) {
        throw e; // Nothing was checked, which is no finding about the project.
      }
      found.addAll(e.diagnostics());
      return Optional.empty();
    }
  }
}
