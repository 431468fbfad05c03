package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.ChainView.Component;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Whether each requirement is taken on by a component. */
final class RequirementCheck {
  private final Set<String> known;
  private final Findings findings;

  RequirementCheck(List<String> known, Findings findings) {
    this.known = new LinkedHashSet<>(known);
    this.findings = findings;
  }

  void check(ChainView chain) {
    Set<String> open = new LinkedHashSet<>(known);
    for (Component component : chain.components()) {
      JsonNode ids = component.json().path("requirements");
      for (int i = 0; i < ids.size(); i++) {
        open.remove(ids.path(i).asText());
      }
    }
    for (String id : open) {
      findings.error(
          "agents.requirement.unsatisfied",
          "",
          "No component contributes to the requirement %s.".formatted(id),
          "Name it with the component that does, or add one.");
    }
  }
}
