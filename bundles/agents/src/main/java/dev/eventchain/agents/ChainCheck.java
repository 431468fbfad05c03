package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.modeler.SoftwareBase;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a designed chain must be beyond its format, given the requirements and the software that
 * exists.
 */
final class ChainCheck {
  private final List<String> requirements;
  private final Map<String, JsonNode> existing = new LinkedHashMap<>();
  private final Map<String, Signal> signals;

  /**
   * Prepares the check.
   *
   * @param signals the existing signals, as signals.json describes them
   */
  ChainCheck(Requirements requirements, List<SoftwareBase.Component> components, JsonNode signals) {
    this.requirements = requirements.items().stream().map(Requirements.Item::id).toList();
    components.forEach(component -> existing.put(component.name(), component.json()));
    this.signals = Signal.read(signals);
  }

  List<Diagnostic> check(JsonText text) {
    Findings findings = new Findings(text);
    ChainView chain = ChainView.of(text.root());
    new ComponentCheck(findings).check(chain);
    new FlowCheck(chain, signals, findings).check();
    new RequirementCheck(requirements, findings).check(chain);
    new ReuseCheck(existing, findings).check(chain);
    return findings.diagnostics();
  }
}
