package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/** Reads the section {@code inputs} of a scenario: scripts for the inputs of the bench. */
final class InputsReader {

  private static final NumberRange ANY = NumberRange.of(-1e12, 1e12);
  private static final NumberRange TIME = NumberRange.of(0, 600);

  private InputsReader() {}

  /** Reads the scripts by the names of the inputs, in coherent units. */
  static Map<String, Script> read(ObjectReader section, Bench bench) {
    Map<String, Script> scripts = new LinkedHashMap<>();
    for (String name : section.names()) {
      Signal input = bench.signals().inputs().get(name);
      if (input == null || !bench.signals().isScripted(name)) {
        unknown(section, name, bench);
      } else {
        List<Script.Step> steps = steps(section, name, input.dimension());
        if (!steps.isEmpty()) {
          scripts.put(name, new Script(steps));
        }
      }
    }
    return scripts;
  }

  /** Rejects inputs without effect, which the author of the scenario cannot have intended. */
  static void requireUse(ObjectReader scenario, Set<String> names, Asked asked, Bench bench) {
    List<Expectation> criteria =
        Stream.of(asked.criteria(), asked.conditions(), asked.observed())
            .flatMap(List::stream)
            .toList();
    for (String name : names) {
      boolean judged =
          criteria.stream().anyMatch(UnresolvedCriterion.class::isInstance) // It may read any.
              || criteria.stream()
                  .flatMap(each -> each.signals().stream())
                  .flatMap(Signal::origins)
                  .anyMatch(signal -> signal.name().equals(name));
      if (!judged && !bench.mayNeed(name)) {
        ObjectReader section = scenario.object("inputs").orElseThrow();
        section.find(
            Diagnostic.of(
                    ScenarioRules.INPUT_UNKNOWN,
                    "Nothing that is sent or judged depends on the input '" + name + "'.",
                    section.atKey(name))
                .withHint("Let a field of bench.yaml depend on it, or leave it out."));
      }
    }
  }

  private static void unknown(ObjectReader section, String name, Bench bench) {
    section.value(name);
    section.find(
        Diagnostic.of(
                ScenarioRules.INPUT_UNKNOWN,
                bench.signals().inputs().containsKey(name)
                    ? "The bench computes '" + name + "', so a scenario cannot set it."
                    : "The bench has no input '" + name + "'.",
                section.atKey(name))
            .withHint(NearestName.hint(name, bench.signals().scripted())));
  }

  private static List<Script.Step> steps(ObjectReader section, String name, Unit unit) {
    boolean isList = section.value(name).map(JsonNode::isArray).orElse(false);
    if (!isList) {
      double value = section.requiredNumber(name, ANY);
      return List.of(new Script.Step(0, unit.coherent(value)));
    }
    List<Script.Step> steps = new ArrayList<>();
    long earliest = 0;
    for (ObjectReader step : section.objects(name)) {
      long time = World.nanoseconds(step.requiredNumber("at_s", TIME));
      double value = step.requiredNumber("value", ANY);
      step.refuseOthers();
      boolean first = steps.isEmpty();
      if (first ? time != 0 : time <= earliest) {
        String message =
            first ? "The first step must be at 0 s." : "A step must come after the previous one.";
        step.find(ScenarioRules.VALUE_RANGE, message, step.at("at_s"));
      }
      steps.add(new Script.Step(time, unit.coherent(value)));
      earliest = time;
    }
    if (steps.isEmpty()) {
      section.find(ScenarioRules.VALUE_RANGE, "'" + name + "' has no step.", section.at(name));
    }
    return steps;
  }
}
