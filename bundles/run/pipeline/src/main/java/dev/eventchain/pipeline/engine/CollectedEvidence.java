package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.design.ComponentTestResults;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.About;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Strength;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.simulate.ProjectScenarios;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** Collects the evidence of a run: what was simulated and tested in it, and nothing older. */
final class CollectedEvidence {

  private final RunContext run;
  private final Optional<Simulated> simulated;
  private final List<Diagnostic> found;
  private final Optional<EventChain> chain;
  private final UntestedReasons why;

  private CollectedEvidence(
      RunContext run,
      Optional<Simulated> simulated,
      List<Diagnostic> found,
      List<Diagnostic> suppressed) {
    this.run = run;
    this.simulated = simulated;
    this.found = found;
    this.why = new UntestedReasons(simulated, found, suppressed, run.options().isPartial());
    this.chain = readable(() -> run.chain().chain());
  }

  /**
   * Collects the evidence of a run.
   *
   * @param simulated the report of the simulation, if there was one
   * @param found the findings of the run that count
   * @param suppressed those that do not
   * @param implemented the outcome of the stage that tests components
   * @param summary the verdict in a sentence
   */
  static Evidence of(
      RunContext run,
      Optional<Simulated> simulated,
      List<Diagnostic> found,
      List<Diagnostic> suppressed,
      StageOutcome implemented,
      String summary) {
    return FileReads.unrecorded(
        () ->
            new CollectedEvidence(run, simulated, found, suppressed).collect(implemented, summary));
  }

  private Evidence collect(StageOutcome implemented, String summary) {
    List<Evidence.Test> tests = new ArrayList<>();
    chain
        .flatMap(it -> readable(() -> ComponentTestResults.of(run, it, implemented)))
        .ifPresent(tests::addAll);
    tests.addAll(scenarios());
    return new Evidence(
        run.project().configuration().name(),
        run.project().configuration().title(),
        summary,
        readable(run::writtenRequirements).orElse(List.of()).stream()
            .map(this::requirement)
            .toList(),
        chain.map(EventChain::getSoftware).stream()
            .flatMap(List::stream)
            .map(this::component)
            .toList(),
        tests);
  }

  /** Returns the value; empty if a file cannot be read, which a stage reports. */
  private static <T> Optional<T> readable(Supplier<T> reader) {
    try {
      return Optional.of(reader.get());
    } catch (DiagnosticException e) {
      return Optional.empty();
    }
  }

  private Evidence.Requirement requirement(WrittenRequirement item) {
    Optional<RequirementOutcome> outcome =
        simulated.map(Simulated::requirements).orElse(List.of()).stream()
            .filter(each -> each.id().equals(item.id()))
            .findFirst();
    Verdict verdict = outcome.map(this::verdict).orElse(Verdict.NOT_TESTED);
    return new Evidence.Requirement(
        item.id(),
        item.text(),
        item.location(),
        verdict,
        verdict == Verdict.NOT_TESTED ? Optional.of(why.of(item.id())) : Optional.empty(),
        outcome
            .flatMap(RequirementOutcome::strength)
            .map(it -> new Strength(it.noticed(), it.faults(), it.sampleOf())));
  }

  /**
   * Returns the verdict on a requirement. One about which a finding says that its evidence is not
   * enough, such as a strength below what the project asks for, is not proved.
   */
  private Verdict verdict(RequirementOutcome outcome) {
    boolean wanting =
        found.stream()
            .filter(each -> each.severity() == Severity.ERROR)
            .anyMatch(each -> RunTrials.isAbout(each, outcome.id()));
    return switch (outcome.outcome()) {
      case PROVED -> wanting ? Verdict.NOT_TESTED : Verdict.PROVED;
      case VIOLATED -> Verdict.VIOLATED;
      case NOT_TESTED -> Verdict.NOT_TESTED;
    };
  }

  private Evidence.Component component(SoftwareNode node) {
    SourceLocation place =
        readable(run::softwareBase)
            .flatMap(known -> known.find(node.getName()))
            .map(it -> SourceLocation.of(it.file()))
            .orElseGet(() -> SourceLocation.of(run.file(ComponentFiles.name(node.getName()))));
    return new Evidence.Component(
        node.getName(), place, node.getSatisfies().stream().map(Requirement::getId).toList());
  }

  /** Returns the simulated scenarios; those of the project if nothing was simulated. */
  private List<Evidence.Test> scenarios() {
    List<Scenario> written = readable(() -> ProjectScenarios.read(run)).orElse(List.of());
    if (simulated.isEmpty()) {
      return written.stream().map(CollectedEvidence::unsimulated).toList();
    }
    Map<String, SourceLocation> places = new HashMap<>();
    written.forEach(each -> places.put(each.name(), each.location()));
    return simulated.get().scenarios().stream()
        .map(each -> scenario(each, places.getOrDefault(each.name(), SourceLocation.NONE)))
        .toList();
  }

  private static Evidence.Test unsimulated(Scenario scenario) {
    return new Evidence.Test(
        scenario.name(),
        Optional.empty(),
        scenario.location(),
        Result.NOT_TESTED,
        "not simulated",
        0,
        scenario.requirements().stream().map(it -> new About(it, Result.NOT_TESTED)).toList());
  }

  private static Evidence.Test scenario(SimulatedScenario scenario, SourceLocation place) {
    List<Double> times = scenario.series().time();
    List<About> about = new ArrayList<>();
    for (String id : scenario.requirements()) {
      result(scenario.criteria(), id).ifPresent(it -> about.add(new About(id, it)));
    }
    return new Evidence.Test(
        scenario.name(),
        Optional.empty(),
        place,
        scenario.passed() ? Result.PASSED : scenario.tested() ? Result.FAILED : Result.NOT_TESTED,
        scenario.text(),
        times.isEmpty() ? 0 : times.get(times.size() - 1),
        about);
  }

  /** Returns what the criteria about a requirement say together; empty if there is none. */
  private static Optional<Result> result(List<Criterion> criteria, String requirement) {
    List<Criterion> about =
        criteria.stream()
            .filter(each -> each.requirements().map(it -> it.contains(requirement)).orElse(true))
            .toList();
    if (about.isEmpty()) {
      return Optional.empty();
    }
    if (about.stream().anyMatch(each -> each.tested() && !each.passed())) {
      return Optional.of(Result.FAILED);
    }
    boolean passed = about.stream().allMatch(Criterion::passed);
    return Optional.of(passed ? Result.PASSED : Result.NOT_TESTED);
  }
}
