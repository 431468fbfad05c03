package dev.eventchain.simulation.strength;

import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.verdict.Strength;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** All trials of standard faults, and the strength of requirements that results from them. */
public final class StrengthTrials {

  private final Map<SoftwareNode, List<String>> requirements = new LinkedHashMap<>();
  private final Map<String, List<FaultTrial>> trials = new LinkedHashMap<>();

  /**
   * Prepares the trials.
   *
   * @param runs the runs of all scenarios without faults, with records of their outputs
   */
  public StrengthTrials(SimulatedChain chain, List<ScenarioRun> runs) {
    ScenarioJudge judge = new ScenarioJudge(chain, runs, true);
    List<JudgedScenario> scenarios =
        runs.stream()
            .map(run -> new JudgedScenario(run, judge))
            .filter(each -> each.criteria() > 0)
            .sorted(ORDER)
            .toList();
    List<OutputRecord> records = runs.stream().map(ScenarioRun::outputs).toList();
    Set<String> named = new TreeSet<>();
    scenarios.forEach(each -> named.addAll(each.scenario().requirements()));
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

  /** Scenarios with many criteria for their time first. */
  private static final Comparator<JudgedScenario> ORDER =
      Comparator.comparingDouble(StrengthTrials::secondsPerCriterion)
          .thenComparing(each -> each.scenario().name());

  private static double secondsPerCriterion(JudgedScenario scenario) {
    return scenario.scenario().duration() / scenario.criteria();
  }

  private static List<FaultTrial> trials(
      SoftwareNode node,
      SimulatedChain chain,
      List<String> ids,
      List<JudgedScenario> scenarios,
      List<OutputRecord> records) {
    List<Output> outputs = Output.of(node, chain.catalog());
    return StandardFaults.of(outputs, records).stream()
        .map(fault -> new FaultTrial(fault, ids, scenarios, fields(outputs, fault)))
        .toList();
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
  public List<FaultTrial> all() {
    return trials.values().stream().flatMap(List::stream).toList();
  }

  /**
   * Returns the trials that go on with further scenarios after all of them have ended: those for
   * requirements that have noticed nothing so far.
   */
  public List<FaultTrial> extended() {
    Set<String> open = new TreeSet<>();
    for (Strength.Requirement each : requirements()) {
      if (each.noticed() == 0) {
        open.add(each.id());
      }
    }
    List<FaultTrial> more =
        all().stream()
            .filter(trial -> trial.requirements().stream().anyMatch(open::contains))
            .toList();
    more.forEach(FaultTrial::extend);
    return more;
  }

  /** Returns the strength of each requirement, as far as the trials have come. */
  public Strength strength() {
    return new Strength(requirements(), all().stream().mapToInt(FaultTrial::runs).sum());
  }

  private List<Strength.Requirement> requirements() {
    Set<String> ids = new TreeSet<>();
    requirements.values().forEach(ids::addAll);
    return ids.stream().map(this::requirement).toList();
  }

  private Strength.Requirement requirement(String id) {
    List<String> components =
        requirements.keySet().stream()
            .filter(node -> requirements.get(node).contains(id))
            .map(SoftwareNode::getName)
            .toList();
    boolean needed =
        components.stream()
            .flatMap(node -> trials.get(node).stream())
            .anyMatch(trial -> trial.fault().isOmission() && trial.noticedAtAll());
    return new Strength.Requirement(
        id, components, needed, all().stream().flatMap(it -> it.reaction(id).stream()).toList());
  }
}
