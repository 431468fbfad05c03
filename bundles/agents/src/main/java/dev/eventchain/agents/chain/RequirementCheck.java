package dev.eventchain.agents.chain;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.description.ChainNames;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Checks that each requirement is assigned to a component. */
public final class RequirementCheck {
  private final Set<String> known;
  private final Findings findings;

  RequirementCheck(List<String> known, Findings findings) {
    this.known = new LinkedHashSet<>(known);
    this.findings = findings;
  }

  void check(ChainView chain) {
    Set<String> open = new LinkedHashSet<>(known);
    for (Component component : chain.components()) {
      JsonNode ids = component.json().path(ChainNames.REQUIREMENTS);
      for (int i = 0; i < ids.size(); i++) {
        open.remove(ids.path(i).asText());
      }
    }
    for (String id : open) {
      findings.add(
          ChainRules.REQUIREMENT_UNSATISFIED,
          "",
          "No component contributes to the requirement %s.".formatted(id),
          "Name it with the component that does, or add one.");
    }
  }

  /** Returns the requirements that a component contributes to, according to its description. */
  public static List<WrittenRequirement> own(JsonNode component, Requirements requirements) {
    List<String> ids = new ArrayList<>();
    component.path(ChainNames.REQUIREMENTS).forEach(id -> ids.add(id.asText()));
    return requirements.items().stream().filter(item -> ids.contains(item.id())).toList();
  }
}
