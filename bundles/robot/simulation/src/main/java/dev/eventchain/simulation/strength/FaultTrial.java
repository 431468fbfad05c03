package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.run.OutputFaultRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.verdict.Strength.Reaction;
import dev.eventchain.simulation.world.Trace;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A fault in one scenario after the other, until the criteria of each requirement have noticed it
 * or no scenario is left. Each run is judged for all requirements at once.
 */
public final class FaultTrial {

  /**
   * The number of scenarios of a requirement in which a fault is tried. Further ones are tried only
   * for requirements that have noticed no fault at all.
   */
  private static final int MOST_SCENARIOS = 3;

  private final OutputFault fault;
  private final List<String> requirements;
  private final List<JudgedScenario> left;
  private final SortedMap<String, Attempts> attempts = new TreeMap<>();
  private int limit = MOST_SCENARIOS;
  private boolean noticedAtAll;
  private int runs;

  /** What the criteria of a requirement did so far. */
  private static final class Attempts {
    private int count;
    private double nearest = Double.POSITIVE_INFINITY;
    private Optional<Reaction> reaction = Optional.empty();

    private boolean noticed() {
      return reaction.filter(Reaction::noticed).isPresent();
    }
  }

  /**
   * Creates a trial.
   *
   * @param requirements those that the component with the fault satisfies
   * @param scenarios all scenarios, in the order of the trial
   * @param fields the fields of the fault's topic that the component writes
   */
  FaultTrial(
      OutputFault fault,
      List<String> requirements,
      List<JudgedScenario> scenarios,
      List<String> fields) {
    this.fault = fault;
    this.requirements = requirements;
    this.left = new ArrayList<>(scenarios);
    left.removeIf(scenario -> !scenario.canChange(fault, fields));
    requirements.forEach(id -> attempts.put(id, new Attempts()));
  }

  OutputFault fault() {
    return fault;
  }

  /** Returns whether a criterion of any scenario noticed the fault. */
  boolean noticedAtAll() {
    return noticedAtAll;
  }

  /** Returns the number of runs so far. */
  int runs() {
    return runs;
  }

  /** Returns the reaction of a requirement; empty if the fault changed nothing in its scenarios. */
  Optional<Reaction> reaction(String requirement) {
    Attempts made = attempts.get(requirement);
    return made == null ? Optional.empty() : made.reaction;
  }

  /** Allows all scenarios. */
  void extend() {
    limit = Integer.MAX_VALUE;
  }

  /** Returns a description for users. */
  public String words() {
    return fault.words();
  }

  /**
   * Runs the next scenario.
   *
   * @return the run; empty if no scenario is left
   */
  public Optional<OutputFaultRun> next(ScenarioRunner runner) {
    Optional<JudgedScenario> scenario = choose();
    return scenario.map(
        each -> {
          left.remove(each);
          OutputFaultRun run =
              runner.run(each.scenario(), fault, beginning -> isDecided(each, beginning));
          runs++;
          judge(each, run);
          return run;
        });
  }

  /** Returns the next scenario of a run that may show something new. */
  private Optional<JudgedScenario> choose() {
    Optional<JudgedScenario> about =
        left.stream()
            .filter(each -> requirements.stream().anyMatch(id -> isOpen(each, id)))
            .findFirst();
    return about.isEmpty() && fault.isOmission() && !noticedAtAll
        ? left.stream().findFirst()
        : about;
  }

  private boolean isOpen(JudgedScenario scenario, String requirement) {
    return scenario.names(requirement) && isOpen(attempts.get(requirement));
  }

  private boolean isOpen(Attempts made) {
    return !made.noticed() && made.count < limit;
  }

  /**
   * Returns whether a run need not go on: a criterion has noticed the fault, and so has one of each
   * requirement that a criterion of the scenario belongs to.
   */
  private boolean isDecided(JudgedScenario scenario, Trace beginning) {
    Set<Integer> violated = scenario.violated(beginning);
    return !violated.isEmpty()
        && requirements.stream()
            .filter(id -> scenario.names(id) && !attempts.get(id).noticed())
            .allMatch(id -> isDecided(scenario, violated, id));
  }

  private static boolean isDecided(JudgedScenario scenario, Set<Integer> violated, String id) {
    Set<Integer> proving = scenario.proving(id);
    return proving.isEmpty() || proving.stream().anyMatch(violated::contains);
  }

  private void judge(JudgedScenario scenario, OutputFaultRun run) {
    if (!run.tookEffect()) {
      return;
    }
    List<CriterionResult> results =
        run.ended().isPresent() ? List.of() : scenario.results(run.run());
    for (String id : requirements) {
      if (scenario.names(id) && !attempts.get(id).noticed()) {
        add(attempts.get(id), id, scenario, results);
      }
    }
    for (int i = 0; i < results.size(); i++) {
      noticedAtAll |= scenario.result(i).passed() && fails(results.get(i));
    }
  }

  private void add(
      Attempts made, String id, JudgedScenario scenario, List<CriterionResult> results) {
    made.count++;
    if (made.reaction.isEmpty()) {
      made.reaction = Optional.of(reaction(false, scenario, "", Optional.empty()));
    }
    for (int i = 0; i < results.size(); i++) {
      CriterionResult result = results.get(i);
      if (scenario.proves(i, id)) {
        if (fails(result)) {
          made.reaction = Optional.of(reaction(true, scenario, result.text(), result.margin()));
          return;
        }
        double left = result.leftOf(scenario.result(i));
        if (left < made.nearest) {
          made.nearest = left;
          made.reaction = Optional.of(reaction(false, scenario, result.text(), result.margin()));
        }
      }
    }
  }

  private static boolean fails(CriterionResult result) {
    return result.tested() && !result.passed();
  }

  private Reaction reaction(
      boolean noticed, JudgedScenario scenario, String criterion, Optional<Margin> margin) {
    return new Reaction(fault.words(), noticed, scenario.scenario().name(), criterion, margin);
  }

  /** Returns the requirements, in their order. */
  List<String> requirements() {
    return new ArrayList<>(requirements);
  }
}
