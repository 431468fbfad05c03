package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Requirements that the scenarios can test, whatever their outcome. */
final class RequirementCoverage {

  private static final Rule UNTESTED = SimulateRules.PROJECT_REQUIREMENT_UNTESTED;

  /** Findings that name an untested requirement. */
  private static final Set<Rule> NAMING =
      Set.of(
          UNTESTED,
          SimulateRules.PROJECT_REQUIREMENT_STALE,
          SimulateRules.SIMULATION_STRENGTH_NONE,
          SimulateRules.SIMULATION_STRENGTH_IDLE);

  private final SoftwareBase base;
  private final EventChain chain;
  private final TopicIndex topics;
  private final Bench bench;
  private final List<Scenario> scenarios;

  private RequirementCoverage(
      RunContext run, EventChain chain, Bench bench, List<Scenario> scenarios) {
    this.base = run.softwareBase();
    this.chain = chain;
    this.topics = TopicIndex.of(chain);
    this.bench = bench;
    this.scenarios = scenarios;
  }

  /** Returns the scenarios without the criteria that their runs did not ask. */
  static List<Scenario> judged(List<Scenario> scenarios, SimulationResult result) {
    Map<String, Set<SourceLocation>> observed = new HashMap<>();
    result
        .verdicts()
        .forEach(
            verdict ->
                observed.put(
                    verdict.scenario(),
                    verdict.observed().stream()
                        .map(ScenarioVerdict.CriterionResult::location)
                        .collect(Collectors.toSet())));
    return scenarios.stream()
        .map(each -> each.without(observed.getOrDefault(each.name(), Set.of())))
        .toList();
  }

  /**
   * Returns an error for each requirement that no scenario tests, and that passing scenarios do not
   * prove.
   */
  static List<Diagnostic> untested(RunContext run, EventChain chain, List<Scenario> scenarios) {
    Map<String, String> unproven = unproven(run, chain, scenarios);
    Set<String> named =
        scenarios.stream()
            .flatMap(scenario -> scenario.requirements().stream())
            .collect(Collectors.toSet());
    List<Diagnostic> found = new ArrayList<>();
    for (WrittenRequirement item : run.writtenRequirements()) {
      if (!named.contains(item.id())) {
        found.add(
            untested(
                item,
                "No scenario tests the requirement " + item.id() + ".",
                "Name it under 'requirements' of a scenario that does"));
      } else if (unproven.containsKey(item.id())) {
        found.add(
            untested(
                item,
                unproven.get(item.id()),
                "Write a criterion on it into a scenario that names the requirement"));
      }
    }
    return found;
  }

  /**
   * Returns a finding for each requirement that is untested because of a suppressed finding, but
   * not suppressed itself: people who suppress a finding may not know which requirements depend on
   * it.
   *
   * @param outcomes the outcomes from {@link RequirementOutcomes#of}
   * @param found all findings so far; as long as one of them counts, nothing is added
   */
  static List<Diagnostic> unlisted(
      RunContext run, List<RequirementOutcome> outcomes, List<Diagnostic> found) {
    Suppressions.Parted parted = run.options().suppressions().part(found);
    if (Diagnostic.anyError(parted.remaining())) {
      return List.of();
    }
    Set<String> listed =
        parted.suppressed().stream()
            .map(Suppressions.Suppressed::finding)
            .filter(finding -> NAMING.stream().anyMatch(finding::is))
            .map(Diagnostic::rule)
            .collect(Collectors.toSet());
    Set<String> untested = RequirementOutcomes.untested(outcomes);
    return run.writtenRequirements().stream()
        .filter(item -> untested.contains(item.id()) && !listed.contains(item.id()))
        .map(
            item ->
                untested(
                    item,
                    "Something that " + item.id() + " depends on could not be judged.",
                    "Let its scenarios test it"))
        .toList();
  }

  private static Diagnostic untested(WrittenRequirement item, String message, String hint) {
    return Diagnostic.of(UNTESTED, message, item.location())
        .withRule(item.id())
        .withHint(hint + ", or suppress this finding with a reason and an expiry date.");
  }

  /**
   * Returns the reasons, by identifier, why requirements of scenarios cannot be proved by any of
   * their criteria. A requirement on an output signal needs a criterion on its value, any other one
   * a criterion that depends on outputs of the components that satisfy it.
   */
  static Map<String, String> unproven(RunContext run, EventChain chain, List<Scenario> scenarios) {
    RequirementCoverage coverage =
        new RequirementCoverage(run, chain, run.bench().withOutputsOf(chain), scenarios);
    Map<String, String> unproven = new TreeMap<>();
    coverage.findIndependent(run.writtenRequirements(), unproven);
    coverage.findUnread(unproven);
    return unproven;
  }

  /**
   * Adds requirements on output signals that no criterion reads: the simulated world does not show
   * whether they are sent.
   */
  private void findUnread(Map<String, String> unproven) {
    for (SoftwareNode node : chain.getSoftware()) {
      for (Data output : node.getOutput()) {
        Optional<String> topic = TopicIndex.nameOf(output, node);
        if (output.isExternal() && topic.isPresent()) {
          String signal = topic.get() + "." + output.getFieldName();
          String message =
              "No criterion reads %s, which is an output of the chain because %s requires it.";
          output.getSatisfies().stream()
              .map(Requirement::getId)
              .filter(id -> about(id).stream().noneMatch(it -> it.reads(id).contains(signal)))
              .forEach(id -> unproven.put(id, message.formatted(signal, id)));
        }
      }
    }
  }

  /** Returns whether a node runs in the simulation: around a component, or as it is. */
  private boolean isSimulated(SoftwareNode node) {
    return node.getImplementation() == ComponentImplementation.COMPONENT
        || base.find(String.valueOf(node.getName()))
            .flatMap(SoftwareBase.Component::node)
            .isPresent();
  }

  private void findIndependent(
      List<WrittenRequirement> requirements, Map<String, String> unproven) {
    for (WrittenRequirement item : requirements) {
      List<SoftwareNode> satisfying =
          chain.getSoftware().stream()
              .filter(
                  node -> node.getSatisfies().stream().anyMatch(it -> item.id().equals(it.getId())))
              .toList();
      Set<String> influenced = topics.influencedBy(satisfying, this::isSimulated);
      if (satisfying.isEmpty()) {
        unproven.put(
            item.id(),
            "No component of the chain is marked as satisfying %s, so no criterion can test it."
                .formatted(item.id()));
      } else if (about(item.id()).stream()
          .noneMatch(it -> it.dependsOn(item.id(), influenced, bench))) {
        unproven.put(
            item.id(),
            "No criterion that tests %s depends on what %s writes to satisfy it."
                .formatted(item.id(), names(satisfying)));
      }
    }
  }

  private List<Scenario> about(String requirement) {
    return scenarios.stream().filter(it -> it.requirements().contains(requirement)).toList();
  }

  private static String names(List<SoftwareNode> nodes) {
    return nodes.stream()
        .map(node -> "'" + node.getName() + "'")
        .distinct()
        .collect(Collectors.joining(" or "));
  }
}
