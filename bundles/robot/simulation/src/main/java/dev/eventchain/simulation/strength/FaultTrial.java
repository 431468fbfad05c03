package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.run.OutputFaultRun;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Margin;
import dev.eventchain.simulation.verdict.Strength.Reaction;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/**
 * A fault in one scenario after the other, until the criteria of each requirement have noticed it
 * or no scenario is left. Each run is judged for all requirements at once.
 */
public final class FaultTrial {

  private final OutputFault fault;
  private final List<String> requirements;
  private final List<JudgedScenario> scenarios;
  private State state = new State();
  private State kept = state;
  private Aim aim = new Aim(Set.of(), 0, false);

  /** State of the criteria of a requirement so far. */
  private record Attempts(int count, double nearest, Optional<Reaction> reaction) {

    private static final Attempts NONE =
        new Attempts(0, Double.POSITIVE_INFINITY, Optional.empty());

    private boolean noticed() {
      return reaction.filter(Reaction::noticed).isPresent();
    }
  }

  /** All that runs have shown. */
  private static final class State {
    private final List<JudgedScenario> driven = new ArrayList<>();
    private final SortedMap<String, Attempts> attempts = new TreeMap<>();
    private boolean noticedAtAll;
    private long nanoseconds;

    private State copy() {
      State copy = new State();
      copy.driven.addAll(driven);
      copy.attempts.putAll(attempts);
      copy.noticedAtAll = noticedAtAll;
      copy.nanoseconds = nanoseconds;
      return copy;
    }
  }

  /**
   * Purpose of further runs.
   *
   * @param requirements those that may notice the fault
   * @param limit the number of their scenarios in which it is tried
   * @param everywhere true to go on until any criterion of any scenario has noticed it
   */
  private record Aim(Set<String> requirements, int limit, boolean everywhere) {}

  /**
   * Creates a trial.
   *
   * @param requirements those that the component with the fault satisfies
   * @param scenarios all scenarios
   * @param fields the fields of the fault's topic that the component writes
   */
  FaultTrial(
      OutputFault fault,
      List<String> requirements,
      List<JudgedScenario> scenarios,
      List<String> fields) {
    this.fault = fault;
    this.requirements = List.copyOf(requirements);
    this.scenarios =
        scenarios.stream().filter(scenario -> scenario.canChange(fault, fields)).toList();
  }

  /**
   * Sets what further runs are for, which also makes the runs so far those to go back to.
   *
   * @param some the requirements that may notice it; others are not asked
   * @param limit the number of scenarios of each
   */
  void aim(Collection<String> some, int limit) {
    Set<String> ids = new TreeSet<>(requirements);
    ids.retainAll(some);
    kept = state.copy();
    aim = new Aim(ids, limit, false);
    ids.forEach(id -> state.attempts.putIfAbsent(id, Attempts.NONE));
  }

  /** Sets that further runs are for any criterion of any scenario. */
  void aimEverywhere() {
    kept = state.copy();
    aim = new Aim(Set.of(), 0, true);
  }

  /** Forgets the runs since the last aim. */
  void goBack() {
    state = kept.copy();
  }

  OutputFault fault() {
    return fault;
  }

  /** Returns whether its component does nothing, or always the same. */
  boolean isOmission() {
    return fault.isOmission();
  }

  /** Returns whether it can change anything in a scenario of a requirement. */
  boolean isPossible() {
    return requirements.stream().anyMatch(this::isPossible);
  }

  private boolean isPossible(String requirement) {
    return scenarios.stream().anyMatch(each -> each.proves(requirement));
  }

  /** Returns whether a requirement was asked. */
  boolean isTried() {
    return !state.attempts.isEmpty();
  }

  /** Returns whether a requirement might notice it, but was not asked. */
  boolean leavesOut(String requirement) {
    return requirements.contains(requirement)
        && !state.attempts.containsKey(requirement)
        && isPossible(requirement);
  }

  /** Returns whether a criterion of any scenario noticed the fault. */
  boolean noticedAtAll() {
    return state.noticedAtAll;
  }

  /** Returns the number of runs so far. */
  int runs() {
    return state.driven.size();
  }

  /** Returns the simulated time of the runs so far, in s. */
  double seconds() {
    return World.seconds(state.nanoseconds);
  }

  /** Returns the reaction of a requirement; empty if the fault changed nothing in its scenarios. */
  Optional<Reaction> reaction(String requirement) {
    return state.attempts.getOrDefault(requirement, Attempts.NONE).reaction();
  }

  /** Returns whether a requirement has noticed it. */
  boolean isNoticedBy(String requirement) {
    return reaction(requirement).filter(Reaction::noticed).isPresent();
  }

  /** Returns whether its component satisfies one of some requirements. */
  boolean concerns(Collection<String> some) {
    return requirements.stream().anyMatch(some::contains);
  }

  /** Returns a description for users. */
  public String words() {
    return fault.words();
  }

  /** Returns whether there is a scenario to run. */
  boolean isOpen() {
    return choose().isPresent();
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
          OutputFaultRun run =
              runner.run(each.scenario(), fault, beginning -> isDecided(each, beginning));
          state.driven.add(each);
          state.nanoseconds += run.simulated();
          judge(each, run);
          return run;
        });
  }

  private Stream<JudgedScenario> left() {
    return scenarios.stream().filter(each -> !state.driven.contains(each));
  }

  /**
   * Returns the scenario that is next: of all that may show something new, the one with most
   * criteria for its time.
   */
  private Optional<JudgedScenario> choose() {
    if (aim.everywhere()) {
      return state.noticedAtAll
          ? Optional.empty()
          : left().max(order(each -> each.criteria() / each.seconds()));
    }
    Set<String> open = new TreeSet<>(aim.requirements());
    open.removeIf(id -> !isOpen(id));
    return left()
        .filter(each -> open.stream().anyMatch(each::proves))
        .max(order(each -> criteria(each, open) / each.seconds()));
  }

  private static double criteria(JudgedScenario scenario, Set<String> open) {
    return open.stream().mapToInt(id -> scenario.proving(id).size()).sum();
  }

  private static Comparator<JudgedScenario> order(ToDoubleFunction<JudgedScenario> relevance) {
    return Comparator.comparingDouble(relevance)
        .thenComparing(each -> each.scenario().name(), Comparator.reverseOrder());
  }

  private boolean isOpen(String requirement) {
    Attempts made = state.attempts.getOrDefault(requirement, Attempts.NONE);
    return !made.noticed() && made.count() < aim.limit();
  }

  /**
   * Returns whether a run need not go on: a criterion has noticed the fault, and so has one of each
   * requirement that a criterion of the scenario belongs to.
   */
  private boolean isDecided(JudgedScenario scenario, Trace beginning) {
    Set<Integer> violated = scenario.violated(beginning);
    return !violated.isEmpty()
        && aim.requirements().stream()
            .filter(id -> scenario.proves(id) && !state.attempts.get(id).noticed())
            .allMatch(id -> scenario.proving(id).stream().anyMatch(violated::contains));
  }

  private void judge(JudgedScenario scenario, OutputFaultRun run) {
    if (!run.tookEffect()) {
      return;
    }
    List<CriterionResult> results =
        run.ended().isPresent() ? List.of() : scenario.results(run.run());
    state.attempts.replaceAll(
        (id, made) ->
            scenario.proves(id) && !made.noticed() ? add(made, id, scenario, results) : made);
    for (int i = 0; i < results.size(); i++) {
      state.noticedAtAll |= scenario.result(i).passed() && fails(results.get(i));
    }
  }

  private Attempts add(
      Attempts made, String id, JudgedScenario scenario, List<CriterionResult> results) {
    double nearest = made.nearest();
    Optional<Reaction> reaction =
        made.reaction().or(() -> Optional.of(reaction(false, scenario, "", Optional.empty())));
    for (int i = 0; i < results.size(); i++) {
      CriterionResult result = results.get(i);
      if (scenario.proves(i, id)) {
        boolean noticed = fails(result);
        double left = result.leftOf(scenario.result(i));
        if (noticed || left < nearest) {
          nearest = left;
          reaction = Optional.of(reaction(noticed, scenario, result.text(), result.margin()));
        }
        if (noticed) {
          break;
        }
      }
    }
    return new Attempts(made.count() + 1, nearest, reaction);
  }

  private static boolean fails(CriterionResult result) {
    return result.tested() && !result.passed();
  }

  private Reaction reaction(
      boolean noticed, JudgedScenario scenario, String criterion, Optional<Margin> margin) {
    return new Reaction(
        fault.node(), fault.words(), noticed, scenario.scenario().name(), criterion, margin, false);
  }
}
