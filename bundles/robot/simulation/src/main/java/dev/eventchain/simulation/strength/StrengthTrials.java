package dev.eventchain.simulation.strength;

import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.verdict.StrengthBudget;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** All trials of standard faults, and the strength of requirements that results from them. */
public final class StrengthTrials {

  /**
   * The number of scenarios of a requirement in which a fault is tried. Further ones are tried only
   * for requirements that have noticed no fault at all, or fewer than the project asks for.
   */
  private static final int MOST_SCENARIOS = 3;

  /** The sample, and rounds for requirements that it does not show to be tested. */
  private static final int ROUNDS = 5;

  private final Map<SoftwareNode, List<String>> requirements = new LinkedHashMap<>();
  private final Map<String, List<FaultTrial>> trials = new LinkedHashMap<>();
  private final Branches branches;
  private final StrengthBudget budget;
  private Optional<TrialRound<FaultTrial>> last = Optional.empty();
  private int rounds;

  /**
   * Prepares the trials.
   *
   * @param runs the runs of all scenarios without faults, with records of their outputs
   */
  public StrengthTrials(SimulatedChain chain, List<ScenarioRun> runs, StrengthBudget budget) {
    this.budget = budget;
    this.branches = new Branches(chain.flow());
    ScenarioJudge judge = new ScenarioJudge(chain, runs, true);
    List<JudgedScenario> scenarios =
        runs.stream()
            .map(run -> new JudgedScenario(run, judge))
            .filter(each -> each.criteria() > 0)
            .toList();
    List<OutputRecord> records = runs.stream().map(ScenarioRun::outputs).toList();
    Set<String> named = new TreeSet<>();
    scenarios.forEach(each -> named.addAll(each.proved()));
    for (SoftwareNode node : chain.nodes()) {
      List<String> ids =
          node.getSatisfies().stream()
              .map(Requirement::getId)
              .filter(named::contains)
              .distinct()
              .toList();
      if (!ids.isEmpty()) {
        requirements.put(node, ids);
        trials.put(node.getName(), trials(node, chain, ids, scenarios, records));
      }
    }
  }

  private static List<FaultTrial> trials(
      SoftwareNode node,
      SimulatedChain chain,
      List<String> ids,
      List<JudgedScenario> scenarios,
      List<OutputRecord> records) {
    List<Output> outputs = Output.of(node, chain.catalog());
    return StandardFaults.of(outputs, records).stream()
        .map(fault -> trial(fault, node, ids, scenarios, fields(outputs, fault)))
        .toList();
  }

  private static FaultTrial trial(
      OutputFault fault,
      SoftwareNode node,
      List<String> ids,
      List<JudgedScenario> scenarios,
      List<String> fields) {
    OutputPurpose purpose = new OutputPurpose(node);
    List<String> served = ids.stream().filter(id -> purpose.mayServe(fault.topic(), id)).toList();
    return new FaultTrial(fault, served, scenarios, fields);
  }

  private static List<String> fields(List<Output> outputs, OutputFault fault) {
    return outputs.stream()
        .filter(each -> each.topic().equals(fault.topic()))
        .map(Output::path)
        .toList();
  }

  /** Returns the fields to record in runs without faults, by topic. */
  public static Map<String, List<String>> recorded(SimulatedChain chain) {
    Map<String, List<String>> fields = new TreeMap<>();
    for (SoftwareNode node : chain.nodes()) {
      for (Output output : Output.of(node, chain.catalog())) {
        fields.computeIfAbsent(output.topic(), topic -> new ArrayList<>()).add(output.path());
      }
    }
    return fields;
  }

  /** Returns the trials, in the order of the components and their outputs. */
  private List<FaultTrial> all() {
    return trials.values().stream().flatMap(List::stream).toList();
  }

  private List<FaultTrial> possible() {
    return all().stream().filter(FaultTrial::isPossible).toList();
  }

  /**
   * Returns the next trials to drive, after all of the last round have ended; empty if all is
   * known. A fault of the sample is tried as it would be without a budget. Requirements that would
   * not be tested because of the budget go on with the faults that it left out. Before each round,
   * and whatever the budget is, those with a bound get enough faults tried that count for it.
   */
  public Optional<TrialRound<FaultTrial>> next() {
    last.ifPresent(round -> round.leftOut().forEach(FaultTrial::goBack));
    last = Optional.empty();
    while (last.isEmpty() && rounds < ROUNDS) {
      TrialRound<FaultTrial> missing = missing();
      last =
          Optional.of(missing.size() > 0 ? missing : round(++rounds))
              .filter(round -> round.size() > 0);
    }
    return last;
  }

  /** Returns the next trials for bounds that would be compared with a few faults. */
  private TrialRound<FaultTrial> missing() {
    List<Strength.Requirement> counted =
        requirements().stream()
            .filter(each -> budget.minimum().applyAsDouble(each.id()) > 0)
            .map(Strength.Requirement::counted)
            .toList();
    List<FaultTrial> untried = sampleOrder().stream().filter(trial -> !trial.isTried()).toList();
    List<FaultTrial> round = SampleOrder.missing(untried, counted, StrengthTrials::counts);
    Set<String> every = ids(each -> true);
    round.forEach(trial -> trial.aim(every, MOST_SCENARIOS));
    return unlimited(round);
  }

  private static boolean counts(Strength.Requirement counted, FaultTrial trial) {
    return trial.leavesOut(counted.id())
        && counted.leftOut().stream()
            .anyMatch(
                each ->
                    each.component().equals(trial.fault().node())
                        && each.topic().equals(trial.fault().topic()));
  }

  private List<FaultTrial> sampleOrder() {
    return SampleOrder.of(possible(), FaultTrial::fault);
  }

  private TrialRound<FaultTrial> round(int number) {
    return switch (number) {
      case 1 -> sample();
      case 2 -> unlimited(ids(this::isShort), MOST_SCENARIOS);
      case 3 -> unlimited(ids(each -> each.noticed() == 0), Integer.MAX_VALUE);
      case 4 -> everyScenario(ids(each -> isBelowMinimum(each.counted())));
      default -> everywhere(ids(each -> !each.needed()));
    };
  }

  private boolean isShort(Strength.Requirement measured) {
    return measured.noticed() == 0
        || isBelowMinimum(measured)
        || isBelowMinimum(measured.counted());
  }

  private boolean isBelowMinimum(Strength.Requirement measured) {
    return measured.percent() < budget.minimum().applyAsDouble(measured.id());
  }

  private Set<String> ids(Predicate<Strength.Requirement> which) {
    return requirements().stream()
        .filter(which)
        .map(Strength.Requirement::id)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * Returns the trials that the budget allows, and in any case those of omissions, and those that
   * bounds needed, whose time counts.
   */
  private TrialRound<FaultTrial> sample() {
    List<FaultTrial> round =
        sampleOrder().stream().sorted(Comparator.comparing(trial -> !isInAnyCase(trial))).toList();
    int always = (int) round.stream().filter(StrengthTrials::isInAnyCase).count();
    Set<String> every = ids(each -> true);
    round.forEach(trial -> trial.aim(every, MOST_SCENARIOS));
    return new TrialRound<>(round, FaultTrial::seconds, always, budget.seconds());
  }

  private static boolean isInAnyCase(FaultTrial trial) {
    return trial.isTried() || trial.isOmission();
  }

  /** Returns all trials that requirements may notice, in a number of scenarios of each. */
  private TrialRound<FaultTrial> unlimited(Set<String> some, int scenarios) {
    List<FaultTrial> round = possible().stream().filter(trial -> trial.concerns(some)).toList();
    round.forEach(trial -> trial.aim(some, scenarios));
    return unlimited(round);
  }

  /**
   * Returns the faults that requirements have not noticed, in all of their scenarios, as far as the
   * budget goes: no requirement falls short of what the project asks for because of the choice of
   * scenarios.
   */
  private TrialRound<FaultTrial> everyScenario(Set<String> some) {
    List<FaultTrial> round = possible().stream().filter(trial -> trial.concerns(some)).toList();
    round.forEach(trial -> trial.aim(some, Integer.MAX_VALUE));
    List<FaultTrial> open =
        SampleOrder.of(round.stream().filter(FaultTrial::isOpen).toList(), FaultTrial::fault);
    return new TrialRound<>(open, FaultTrial::seconds, 0, budget.seconds());
  }

  /** Returns the omissions of components of requirements, in all scenarios of the project. */
  private TrialRound<FaultTrial> everywhere(Set<String> some) {
    List<FaultTrial> round =
        all().stream().filter(FaultTrial::isOmission).filter(each -> each.concerns(some)).toList();
    round.forEach(FaultTrial::aimEverywhere);
    return unlimited(round);
  }

  private static TrialRound<FaultTrial> unlimited(List<FaultTrial> trials) {
    List<FaultTrial> open = trials.stream().filter(FaultTrial::isOpen).toList();
    return new TrialRound<>(open, FaultTrial::seconds, open.size(), Double.POSITIVE_INFINITY);
  }

  /** Returns the strength of each requirement, as far as the trials have come. */
  public Strength strength() {
    return new Strength(
        requirements(),
        all().stream().mapToInt(FaultTrial::runs).sum(),
        all().stream().mapToDouble(FaultTrial::seconds).sum(),
        (int) possible().stream().filter(FaultTrial::isTried).count(),
        possible().size());
  }

  private List<Strength.Requirement> requirements() {
    Set<String> ids = new TreeSet<>();
    requirements.values().forEach(ids::addAll);
    return ids.stream().map(this::requirement).toList();
  }

  /** Returns the topics of the outputs that are marked with a requirement. */
  private Set<String> askedFor(String id) {
    return requirements.keySet().stream()
        .filter(node -> requirements.get(node).contains(id))
        .flatMap(node -> new OutputPurpose(node).markedWith(id))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private Strength.Requirement requirement(String id) {
    List<SoftwareNode> nodes =
        requirements.keySet().stream().filter(node -> requirements.get(node).contains(id)).toList();
    List<String> components = nodes.stream().map(SoftwareNode::getName).toList();
    Set<String> asked = askedFor(id);
    boolean needed =
        components.stream()
            .flatMap(node -> trials.get(node).stream())
            .filter(trial -> asked.isEmpty() || asked.contains(trial.fault().topic()))
            .anyMatch(trial -> trial.isOmission() && trial.noticedAtAll());
    return new Strength.Requirement(
        id,
        components,
        branches.of(id, nodes),
        asked,
        needed,
        nodes.stream().flatMap(node -> reactions(id, node)).toList(),
        nodes.stream().flatMap(node -> leftOut(id, node)).toList());
  }

  private Stream<Strength.Reaction> reactions(String id, SoftwareNode node) {
    Set<String> others = ofOthers(id, node);
    return trials.get(node.getName()).stream()
        .flatMap(
            trial ->
                trial
                    .reaction(id)
                    .map(it -> it.withElsewhere(others.contains(trial.fault().topic())))
                    .stream());
  }

  private Stream<Strength.LeftOut> leftOut(String id, SoftwareNode node) {
    Set<String> others = ofOthers(id, node);
    return trials.get(node.getName()).stream()
        .filter(trial -> trial.leavesOut(id))
        .map(trial -> trial.fault().topic())
        .map(topic -> new Strength.LeftOut(node.getName(), topic, others.contains(topic)));
  }

  private Set<String> ofOthers(String id, SoftwareNode node) {
    return new OutputPurpose(node)
        .ofOthers(id, noticed(node, id::equals), noticed(node, each -> !each.equals(id)));
  }

  private Set<String> noticed(SoftwareNode node, Predicate<String> which) {
    List<String> ids = requirements.get(node).stream().filter(which).toList();
    return trials.get(node.getName()).stream()
        .filter(trial -> ids.stream().anyMatch(trial::isNoticedBy))
        .map(trial -> trial.fault().topic())
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
