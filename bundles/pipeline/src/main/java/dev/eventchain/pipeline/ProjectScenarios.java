package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.metamodel.TopicIndex;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.Requirement;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.simulation.Scenario;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** The scenarios of a project, and the requirements that they test. */
final class ProjectScenarios {

  private ProjectScenarios() {}

  /**
   * Reads what a verdict will be about, before any language model is asked: a scenario that cannot
   * be read, or that tests a requirement that there is not, would be found when all is paid for.
   *
   * @return the findings about the requirements that the scenarios name
   * @throws DiagnosticException INPUT if the bench or a scenario cannot be read
   */
  static List<Diagnostic> check(RunContext run) {
    List<Scenario> scenarios =
        Scenario.readFolder(run.project().scenarios(), run.bench(), warning -> {});
    List<String> known = requirements(run).stream().map(Requirements.Item::id).toList();
    List<Diagnostic> found = new ArrayList<>();
    if (known.isEmpty()) {
      return found;
    }
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
    return Diagnostic.warning(
            "project.requirement.unknown",
            "The scenario '" + scenario.name() + "' names no requirement, so it proves none.",
            scenario.requirementsLocation())
        .withHint("Name those that it tests: requirements: [ID, ...]");
  }

  private static Diagnostic unknown(Scenario scenario, String id, List<String> known) {
    return Diagnostic.error(
            "project.requirement.unknown",
            "The scenario '%s' tests '%s', which is no requirement of this project."
                .formatted(scenario.name(), id),
            scenario.requirementsLocation())
        .withHint(NearestName.question(id, known));
  }

  /** The requirements, where the project has written any. */
  static List<Requirements.Item> requirements(RunContext run) {
    return Project.isAbsent(run.project().requirements()) ? List.of() : run.requirements().items();
  }

  /**
   * What no scenario tests is not proved by all scenarios passing, nor what asks for a signal that
   * no criterion reads.
   */
  static List<Diagnostic> untested(RunContext run, EventChain chain, List<Scenario> scenarios) {
    Set<String> tested =
        scenarios.stream()
            .flatMap(scenario -> scenario.requirements().stream())
            .collect(Collectors.toSet());
    Map<String, String> unread = unread(chain, scenarios);
    List<Diagnostic> found = new ArrayList<>();
    for (Requirements.Item item : requirements(run)) {
      if (!tested.contains(item.id())) {
        found.add(
            untested(
                item,
                "No scenario tests the requirement " + item.id() + ".",
                "Name it under 'requirements' of a scenario that does"));
      } else if (unread.containsKey(item.id())) {
        found.add(
            untested(
                item,
                "No criterion reads %s, which leaves the chain because %s asks for it."
                    .formatted(unread.get(item.id()), item.id()),
                "Observe its topic in bench.yaml, and write a formula on it into a scenario that"
                    + " names the requirement"));
      }
    }
    return found;
  }

  private static Diagnostic untested(Requirements.Item item, String message, String hint) {
    return Diagnostic.error("project.requirement.untested", message, item.location())
        .withRule(item.id())
        .withHint(hint + ", or suppress this finding with a reason and a last day.");
  }

  /**
   * The requirements that ask for a signal that leaves the chain, and of which no scenario that
   * names them has a criterion on its value: nothing on the road shows whether it is sent.
   *
   * @return the signals by the ids of the requirements, such as {@code /aeb/emergency.data}
   */
  static Map<String, String> unread(EventChain chain, List<Scenario> scenarios) {
    Map<String, String> unread = new TreeMap<>();
    for (SoftwareNode node : chain.getSoftware()) {
      for (Data output : node.getOutput()) {
        Optional<String> topic = TopicIndex.nameOf(output, node);
        if (output.isExternal() && topic.isPresent()) {
          String signal = topic.get() + "." + output.getFieldName();
          output.getSatisfies().stream()
              .map(Requirement::getId)
              .filter(id -> scenarios.stream().noneMatch(it -> proves(it, id, signal)))
              .forEach(id -> unread.put(id, signal));
        }
      }
    }
    return unread;
  }

  private static boolean proves(Scenario scenario, String requirement, String signal) {
    return scenario.requirements().contains(requirement) && scenario.reads().contains(signal);
  }

  /** The scenarios that a run asks for, in the order of their files. */
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
            Diagnostic.error(
                    "project.scenario.unknown",
                    "There is no scenario '" + name + "'.",
                    SourceLocation.of(run.project().scenarios()))
                .withHint("The scenarios are " + String.join(", ", names) + "."));
      }
    }
    return all.stream().filter(scenario -> wanted.contains(scenario.name())).toList();
  }
}
