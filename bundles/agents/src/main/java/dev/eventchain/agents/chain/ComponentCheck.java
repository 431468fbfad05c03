package dev.eventchain.agents.chain;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.description.ChainNames;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Checks properties of a designed component that a description may lack: its frequency, and, for a
 * new component, the types of its values, which its code and its tests depend on.
 */
final class ComponentCheck {
  private static final double HIGHEST_FREQUENCY = 10_000;

  private final Set<String> existing;
  private final Findings findings;

  ComponentCheck(Set<String> existing, Findings findings) {
    this.existing = existing;
    this.findings = findings;
  }

  void check(ChainView chain) {
    for (Component component : chain.components()) {
      if (component.json().isObject()) { // else the reader of descriptions reports it
        frequency(component);
        types(component);
      }
    }
  }

  private void frequency(Component component) {
    JsonNode frequency = component.json().path(ChainNames.FREQUENCY);
    if (frequency.isMissingNode() || frequency.isNull()) {
      findings.add(
          ChainRules.FREQUENCY,
          component.pointer(),
          "'%s' states no frequency.".formatted(component.name()),
          "State it as a number in Hz.");
    } else if (frequency.asDouble() > HIGHEST_FREQUENCY) {
      findings.add(
          ChainRules.FREQUENCY,
          component.pointer() + "/" + ChainNames.FREQUENCY,
          "'%s' cannot execute at %s Hz.".formatted(component.name(), frequency.asText()),
          "State a number in Hz, at most 10000.");
    }
  }

  private void types(Component component) {
    if (existing.contains(component.name())) {
      return;
    }
    Stream.concat(component.inputValues().stream(), component.outputValues().stream())
        .filter(value -> value.type().isBlank())
        .forEach(
            value ->
                findings.add(
                    ChainRules.TYPE,
                    value.pointer(),
                    "The value '%s' of '%s' states no type."
                        .formatted(value.name(), component.name()),
                    "State the type of its field as the message definition writes it."));
  }
}
