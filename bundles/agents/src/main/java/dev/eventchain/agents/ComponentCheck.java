package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.ChainView.Component;

/** What a component of a designed chain must have that a description may lack: a frequency. */
final class ComponentCheck {
  private static final double HIGHEST_FREQUENCY = 10_000;

  private final Findings findings;

  ComponentCheck(Findings findings) {
    this.findings = findings;
  }

  void check(ChainView chain) {
    chain.components().forEach(this::frequency);
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
