package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.simulate.SimulateRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Reasons why requirements are not tested, in words.
 *
 * @param simulated the report of the simulation, if there was one
 * @param found the findings of the run that count
 * @param suppressed those that do not: what they say is a reason all the same
 * @param partial true if only some scenarios were to be simulated
 */
record UntestedReasons(
    Optional<Simulated> simulated,
    List<Diagnostic> found,
    List<Diagnostic> suppressed,
    boolean partial) {

  /** Returns the reason for a requirement that is not tested, without a full stop. */
  String of(String requirement) {
    if (simulated.isEmpty()) {
      return "nothing was simulated";
    }
    if (partial) {
      return "only some scenarios were simulated";
    }
    if (simulated.get().requirements().stream().noneMatch(it -> it.id().equals(requirement))) {
      return "the simulation did not know it";
    }
    return Stream.concat(found.stream(), suppressed.stream())
        .filter(each -> RunTrials.isAbout(each, requirement) || isConstraint(each, requirement))
        .map(each -> each.message().strip().replaceFirst("\\.$", ""))
        .findFirst()
        .or(() -> criteria(requirement))
        .orElse("something that it depends on could not be judged");
  }

  private static boolean isConstraint(Diagnostic finding, String requirement) {
    return finding.is(SimulateRules.SIMULATION_RULE_UNTESTED)
        && Pattern.compile("(?<![\\w.-])" + Pattern.quote(requirement) + "(?![\\w-]|\\.\\w)")
            .matcher(finding.message())
            .find();
  }

  /** Returns the first criterion about a requirement that could not be judged. */
  private Optional<String> criteria(String requirement) {
    List<String> untested = new ArrayList<>();
    for (SimulatedScenario scenario : simulated.orElseThrow().scenarios()) {
      for (Criterion each : scenario.criteria()) {
        if (!each.tested()
            && each.requirements().orElse(scenario.requirements()).contains(requirement)) {
          untested.add(
              "scenario %s: %s: %s".formatted(scenario.name(), each.text(), each.measured()));
        }
      }
    }
    String more = untested.size() > 1 ? " (and " + (untested.size() - 1) + " more)" : "";
    return untested.stream().findFirst().map(it -> it + more);
  }
}
