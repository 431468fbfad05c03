package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.ChainView.Component;
import dev.eventchain.agents.ChainView.Value;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * What a component of a designed chain must have beyond what a description must have: a frequency,
 * and names that stay apart in what is generated.
 */
final class ComponentCheck {
  private static final double HIGHEST_FREQUENCY = 10_000;

  private final Findings findings;

  ComponentCheck(Findings findings) {
    this.findings = findings;
  }

  void check(ChainView chain) {
    Map<String, String> names = new HashMap<>();
    for (Component component : chain.components()) {
      frequency(component);
      component.inputValues().forEach(this::parameter);
      // Files are named after components in lower case.
      String earlier =
          names.putIfAbsent(component.name().toLowerCase(Locale.ROOT), component.name());
      if (earlier != null && !earlier.equals(component.name())) {
        findings.error(
            "agents.name.collision",
            component.pointer() + "/name",
            "'%s' and '%s' would have the same file.".formatted(earlier, component.name()),
            "Names of components differ in more than upper and lower case.");
      }
    }
  }

  private void parameter(Value value) {
    if (value.name().equals("self")) {
      findings.error(
          "agents.name.collision",
          value.pointer() + "/name",
          "'self' cannot be a parameter of execute(), which has one already.",
          "Give the value another name.");
    }
  }

  private void frequency(Component component) {
    JsonNode frequency = component.json().path("frequency");
    if (frequency.isMissingNode()) {
      findings.error(
          "agents.frequency",
          component.pointer(),
          "'%s' states no frequency.".formatted(component.name()),
          "State it as a number in Hz.");
    } else if (frequency.asDouble() > HIGHEST_FREQUENCY) {
      findings.error(
          "agents.frequency",
          component.pointer() + "/frequency",
          "'%s' cannot execute with %s Hz.".formatted(component.name(), frequency.asText()),
          "State a number in Hz, at most 10000.");
    }
  }
}
