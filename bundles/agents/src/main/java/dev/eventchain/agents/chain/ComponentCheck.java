package dev.eventchain.agents.chain;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.ChainView.Port;
import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.description.ChainNames;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Checks properties of a designed component that a description may lack: its frequency, and, for a
 * new component, the types of its values, which its code and its tests depend on, and safe values
 * without which others have no effect.
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
        safeValues(component);
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

  /**
   * While inputs are too old, a message is published only with a safe value for all its fields. An
   * array cannot have one, so that nothing better could be answered about a message with one.
   */
  private void safeValues(Component component) {
    if (existing.contains(component.name())) {
      return;
    }
    for (Port port : component.outputs()) {
      List<Value> safe = port.values().stream().filter(Value::isSafe).toList();
      List<String> others =
          port.values().stream().filter(value -> !value.isSafe()).map(Value::name).toList();
      boolean canBeComplete =
          port.values().stream().noneMatch(value -> value.fieldType().endsWith("]"));
      if (!safe.isEmpty() && !others.isEmpty() && canBeComplete) {
        findings.add(
            ChainRules.SAFE_VALUE,
            safe.get(0).pointer(),
            "'%s' has a safe value that is never published: other values that '%s' writes to %s have none: %s."
                .formatted(
                    safe.get(0).name(), component.name(), port.topic(), String.join(", ", others)),
            "While inputs are too old, a message is published only if each of its values has a"
                + " safe value. Give one to all of them.");
      }
    }
  }
}
