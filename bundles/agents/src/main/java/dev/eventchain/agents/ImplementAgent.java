package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.modeler.JsonDocument;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.python.ComponentProbe;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Implements one component of an event chain as a Python class (the paper's Section IV-C and
 * Appendix B).
 */
public final class ImplementAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("implement/v1");

  private final AgentContext context;
  private final ComponentProbe probe;

  /**
   * An agent that works with a context.
   *
   * @param probe checks the answers, and calls them in a confined process
   */
  public ImplementAgent(AgentContext context, ComponentProbe probe) {
    this.context = context;
    this.probe = probe;
  }

  /**
   * Implements a component.
   *
   * @param chain the event-chain description
   * @param component the name of the component in it
   * @param requirements the functional requirements, of which the component's own are shown to the
   *     model
   * @return the Python file {@code components/NAME.py}
   * @throws IllegalArgumentException if the chain has no such component
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public AgentResult implement(SourceText chain, String component, Requirements requirements) {
    ChainView.Component described =
        ChainView.of(JsonDocument.parse(chain).root()).components().stream()
            .filter(candidate -> candidate.name().equals(component))
            .findFirst()
            .orElseThrow(
                () -> new IllegalArgumentException("the chain has no component " + component));
    Map<String, String> values =
        Map.of(
            "requirements", RuleText.items(ownRequirements(described.json(), requirements)),
            "Description of target software extracted from the event chain description.",
                JsonLayout.of(Budgets.without(described.json())));
    ImplementationCheck check = new ImplementationCheck(probe, described);
    return new RepairLoop(context, "implement", AnswerKind.PYTHON)
        .run("components/" + component + ".py", PROMPT, values, Optional.empty(), check::check);
  }

  private static List<Requirements.Item> ownRequirements(
      JsonNode component, Requirements requirements) {
    return requirements.items().stream()
        .filter(
            item -> {
              for (JsonNode id : component.path("requirements")) {
                if (id.asText().equals(item.id())) {
                  return true;
                }
              }
              return false;
            })
        .toList();
  }
}
