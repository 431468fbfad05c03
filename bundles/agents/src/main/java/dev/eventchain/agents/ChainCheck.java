package dev.eventchain.agents;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.Document;
import dev.eventchain.modeler.Requirements;
import java.util.List;

/** What a designed chain must be beyond its format and its contracts, given the requirements. */
final class ChainCheck {
  private final List<String> requirements;

  ChainCheck(Requirements requirements) {
    this.requirements = requirements.items().stream().map(Requirements.Item::id).toList();
  }

  List<Diagnostic> check(Document text) {
    Findings findings = new Findings(text);
    ChainView chain = ChainView.of(text.root());
    new ComponentCheck(findings).check(chain);
    new OrderCheck(findings).check(chain);
    new RequirementCheck(requirements, findings).check(chain);
    return findings.diagnostics();
  }
}
