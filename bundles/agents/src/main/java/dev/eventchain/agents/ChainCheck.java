package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.modeler.JsonText;
import dev.eventchain.modeler.Requirements;
import java.util.List;
import java.util.Map;

/** What a designed chain must be beyond its format, given the requirements and the signals. */
final class ChainCheck {
  private final List<String> requirements;
  private final Map<String, Signal> signals;

  /**
   * Prepares the check.
   *
   * @param signals the existing signals, as signals.json describes them
   */
  ChainCheck(Requirements requirements, JsonNode signals) {
    this.requirements = requirements.items().stream().map(Requirements.Item::id).toList();
    this.signals = Signal.read(signals);
  }

  List<Diagnostic> check(JsonText text) {
    Findings findings = new Findings(text);
    ChainView chain = ChainView.of(text.root());
    new ComponentCheck(findings).check(chain);
    new FlowCheck(chain, signals, findings).check();
    new RequirementCheck(requirements, findings).check(chain);
    return findings.diagnostics();
  }
}
