package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedFault;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.simulate.RequirementStrength;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * The scenarios, criteria, requirements, faults and component tests of a run as tests with
 * outcomes.
 */
final class RunTrials {

  private static final String CRITERION = "simulation.criterion.";
  private static final String REQUIREMENT = "project.requirement.";
  private static final String STRENGTH = "simulation.strength.";

  private final List<Diagnostic> found;
  private final List<Diagnostic> suppressed;
  private final boolean accepted;
  private final Evidence evidence;
  private final List<Trial> scenarios = new ArrayList<>();
  private final List<Trial> criteria = new ArrayList<>();
  private final Map<String, Double> seconds = new TreeMap<>();
  private final Map<String, Integer> names = new HashMap<>();
  private final Set<Diagnostic> taken = Collections.newSetFromMap(new IdentityHashMap<>());

  private RunTrials(
      List<Diagnostic> found, List<Suppressed> suppressed, boolean accepted, Evidence evidence) {
    this.found = found;
    this.evidence = evidence;
    this.suppressed = suppressed.stream().map(Suppressed::finding).toList();
    this.accepted = accepted;
  }

  /**
   * Returns all tests of a simulation, in its order, and the tests of components.
   *
   * @param simulated the report of the simulation, if there was one
   * @param found the findings of the run that count
   * @param accepted true if the run has passed, so that whatever did not hold was accepted
   * @param evidence what the run says about requirements
   * @param simulates true if the run was to simulate, so that what did not run is missing
   */
  static List<Trial> of(
      Optional<Simulated> simulated,
      List<Diagnostic> found,
      List<Suppressed> suppressed,
      boolean accepted,
      Evidence evidence,
      boolean simulates) {
    RunTrials trials = new RunTrials(found, suppressed, accepted, evidence);
    List<Trial> all = new ArrayList<>();
    simulated.map(trials::all).ifPresent(all::addAll);
    evidence.tests().stream()
        .filter(each -> simulates || each.result() != Evidence.Result.NOT_TESTED)
        .filter(each -> simulated.isEmpty() || each.component().isPresent())
        .map(trials::test)
        .forEach(all::add);
    return all;
  }

  private List<Trial> all(Simulated simulated) {
    simulated.scenarios().forEach(this::scenario);
    List<Trial> all = new ArrayList<>(scenarios);
    all.addAll(criteria);
    simulated.requirements().forEach(each -> all.add(requirement(each)));
    simulated.faults().forEach(each -> all.add(fault(each)));
    return all;
  }

  private void scenario(SimulatedScenario scenario) {
    List<Double> times = scenario.series().time();
    double end = times.isEmpty() ? 0 : times.get(times.size() - 1);
    scenario.requirements().forEach(id -> seconds.merge(id, end, Double::sum));
    boolean excused = !scenario.criteria().isEmpty();
    for (Criterion criterion : scenario.criteria()) {
      Trial trial = criterion(scenario.name(), criterion, end);
      excused &= trial.outcome() != Trial.Outcome.FAILED;
      criteria.add(trial);
    }
    scenarios.add(
        new Trial(
            Trial.Kind.SCENARIO,
            scenario.name(),
            scenario.passed() || scenario.tested() || excused || accepted
                ? outcome(scenario.passed(), excused)
                : Trial.Outcome.UNTESTED,
            scenario.text(),
            end,
            List.of(),
            evidence.tests().stream()
                .filter(each -> each.component().isEmpty())
                .filter(each -> each.name().equals(scenario.name()))
                .map(this::links)
                .findFirst()));
  }

  /** Returns a test of a component, or a scenario that was not simulated. */
  private Trial test(Evidence.Test test) {
    return new Trial(
        test.component().isPresent() ? Trial.Kind.TEST : Trial.Kind.SCENARIO,
        test.fullName(),
        switch (test.result()) {
          case PASSED -> Trial.Outcome.PASSED;
          case FAILED -> accepted ? Trial.Outcome.SKIPPED : Trial.Outcome.FAILED;
          case NOT_TESTED -> Trial.Outcome.UNTESTED;
        },
        test.text(),
        test.seconds(),
        found.stream()
            .filter(each -> test.component().isPresent())
            .filter(each -> each.severity() == Severity.ERROR)
            .filter(each -> isAt(each, test.place()))
            .toList(),
        Optional.of(links(test)));
  }

  private static boolean isAt(Diagnostic finding, SourceLocation place) {
    return finding.location().line() == place.line()
        && finding.location().file().equals(place.file());
  }

  /** Returns the links of a test, of which none shows all of a requirement by itself. */
  private Trial.Evidence links(Evidence.Test test) {
    return new Trial.Evidence(test.place(), List.of(), evidence.supportedBy(test));
  }

  private Trial criterion(String scenario, Criterion criterion, double end) {
    String prefix = "Scenario " + scenario + ": ";
    List<Diagnostic> about =
        criterion.passed() ? List.of() : about(found, prefix, criterion.text());
    boolean isExcused = about.isEmpty() && !about(suppressed, prefix, criterion.text()).isEmpty();
    String name = scenario + ": " + criterion.text();
    int number = names.merge(name, 1, Integer::sum);
    return new Trial(
        Trial.Kind.CRITERION,
        number == 1 ? name : name + " (" + number + ")",
        outcome(criterion.passed(), isExcused),
        (criterion.tested() ? "" : "not tested: ") + criterion.measured(),
        end,
        about);
  }

  /** Returns the first finding about a criterion that no other one has taken. */
  private List<Diagnostic> about(List<Diagnostic> findings, String prefix, String text) {
    return findings.stream()
        .filter(each -> each.id().startsWith(CRITERION) && each.message().startsWith(prefix))
        .filter(each -> each.message().contains(text))
        .filter(taken::add)
        .limit(1)
        .toList();
  }

  private Trial requirement(RequirementOutcome requirement) {
    String id = requirement.id();
    List<Diagnostic> about = found.stream().filter(each -> isAbout(each, id)).toList();
    boolean isExcused = about.isEmpty() && suppressed.stream().anyMatch(each -> isAbout(each, id));
    return new Trial(
        Trial.Kind.REQUIREMENT,
        id,
        outcome(requirement.outcome() == RequirementOutcome.Outcome.PROVED, isExcused),
        words(requirement) + strength(requirement),
        seconds.getOrDefault(id, 0.0),
        about,
        evidence.requirement(id).flatMap(RunTrials::links));
  }

  /** Returns the link of all evidence of a requirement to it; empty if it was not tested. */
  private static Optional<Trial.Evidence> links(Evidence.Requirement requirement) {
    if (requirement.verdict() == Evidence.Verdict.NOT_TESTED) {
      return Optional.empty();
    }
    List<String> id = List.of(requirement.id());
    return Optional.of(
        requirement.isFullyVerified()
            ? new Trial.Evidence(requirement.place(), id, List.of())
            : new Trial.Evidence(requirement.place(), List.of(), id));
  }

  private String words(RequirementOutcome requirement) {
    return evidence
        .requirement(requirement.id())
        .map(it -> it.reason().map(why -> it.words()).orElse(requirement.outcome().words()))
        .orElse(requirement.outcome().words());
  }

  private static String strength(RequirementOutcome requirement) {
    return requirement.strength().map(it -> ", " + RequirementStrength.words(it)).orElse("");
  }

  /** Returns whether a finding is about the evidence for a requirement. */
  static boolean isAbout(Diagnostic finding, String requirement) {
    return (finding.id().startsWith(REQUIREMENT) || finding.id().startsWith(STRENGTH))
        && finding.rule().equals(requirement);
  }

  private Trial fault(SimulatedFault fault) {
    return new Trial(
        Trial.Kind.FAULT,
        fault.name() + " in " + fault.scenario(),
        outcome(fault.passed(), !fault.judged()),
        (fault.judged() ? "" : "not judged: ") + fault.text(),
        fault.vehicle().end(),
        List.of());
  }

  private Trial.Outcome outcome(boolean passed, boolean excused) {
    if (passed) {
      return Trial.Outcome.PASSED;
    }
    return accepted || excused ? Trial.Outcome.SKIPPED : Trial.Outcome.FAILED;
  }
}
