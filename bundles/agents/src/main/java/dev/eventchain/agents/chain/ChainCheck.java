package dev.eventchain.agents.chain;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.Document;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Checks of a designed chain against its requirements, beyond its format and its contracts. */
public final class ChainCheck {
  private final List<String> requirements;
  private final Set<String> existing;

  public ChainCheck(Requirements requirements, SoftwareBase base) {
    this.existing =
        base.components().stream().map(SoftwareBase.Component::name).collect(Collectors.toSet());
    this.requirements = requirements.items().stream().map(WrittenRequirement::id).toList();
  }

  public List<Diagnostic> check(Document text) {
    Findings findings = new Findings(text);
    ChainView chain = ChainView.of(text.root());
    new ComponentCheck(existing, findings).check(chain);
    new OrderCheck(findings).check(chain);
    new RequirementCheck(requirements, findings).check(chain);
    return findings.diagnostics();
  }
}
