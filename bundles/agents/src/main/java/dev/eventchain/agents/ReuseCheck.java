package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.ChainView.Component;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/** Whether existing components are used as they are: their code is there and will not change. */
final class ReuseCheck {
  private final Map<String, JsonNode> existing;
  private final Findings findings;

  /**
   * Prepares the check.
   *
   * @param existing the existing components' descriptions by name
   */
  ReuseCheck(Map<String, JsonNode> existing, Findings findings) {
    this.existing = existing;
    this.findings = findings;
  }

  void check(ChainView chain) {
    for (Component component : chain.components()) {
      JsonNode json = existing.get(component.name());
      if (json != null) {
        Component base = ChainView.component(json, "");
        ports(component, "input", values(component.inputs()), values(base.inputs()));
        ports(component, "output", values(component.outputs()), values(base.outputs()));
        frequency(component, json.path("frequency"));
      }
    }
  }

  private void ports(Component component, String kind, Set<String> here, Set<String> there) {
    List<String> missing = there.stream().filter(value -> !here.contains(value)).toList();
    List<String> added = here.stream().filter(value -> !there.contains(value)).toList();
    if (!missing.isEmpty() || !added.isEmpty()) {
      String changes =
          (missing.isEmpty() ? "" : " Missing: " + String.join(", ", missing) + ".")
              + (added.isEmpty() ? "" : " Not there before: " + String.join(", ", added) + ".");
      findings.error(
          "agents.component.changed",
          component.pointer() + "/" + kind,
          "'%s' exists, but its %s is described differently.%s"
              .formatted(component.name(), kind, changes),
          "Describe an existing component as it is, or define a new one with another name.");
    }
  }

  private void frequency(Component component, JsonNode base) {
    JsonNode frequency = component.json().path("frequency");
    if (base.isNumber() && frequency.isNumber() && base.asDouble() != frequency.asDouble()) {
      findings.error(
          "agents.component.changed",
          component.pointer() + "/frequency",
          "'%s' exists and executes with %s Hz, not %s Hz."
              .formatted(component.name(), base.asText(), frequency.asText()),
          "Describe an existing component as it is.");
    }
  }

  private static Set<String> values(List<ChainView.Port> ports) {
    return ports.stream()
        .flatMap(
            port ->
                port.values().stream()
                    .map(
                        value ->
                            "%s (%s of %s, %s)"
                                .formatted(
                                    value.name(),
                                    value.field(),
                                    port.topic(),
                                    MessageTypes.qualified(port.messageType()).orElse("?"))))
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }
}
