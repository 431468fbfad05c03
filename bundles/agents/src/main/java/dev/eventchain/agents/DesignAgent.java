package dev.eventchain.agents;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.chain.ChainCheck;
import dev.eventchain.agents.prompt.DesignSchema;
import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.agents.prompt.SignalText;
import dev.eventchain.contracts.ChainAnalysis;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.description.EventChainSchema;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Designs an event chain from requirements and existing software (the paper's Section IV-A and
 * Appendix A).
 */
public final class DesignAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("design/v1");
  private static final PromptTemplate AGAIN = PromptTemplate.load("redesign/v1");

  private final AgentContext context;

  /** Creates an agent for a context. */
  public DesignAgent(AgentContext context) {
    this.context = context;
  }

  /**
   * Subject of a design.
   *
   * @param system name of the system: "Autonomous Emergency Braking"
   * @param frequency Hz, for new components unless the requirements ask for another one
   * @param requirements the functional requirements, each to be assigned to a component
   * @param designRules requirements on the chain as a whole; may be empty
   * @param base the existing components and signals
   * @param messages the available message types
   */
  public record Asked(
      String system,
      double frequency,
      Requirements requirements,
      Optional<Requirements> designRules,
      SoftwareBase base,
      MessageCatalog messages) {}

  /**
   * Designs a chain.
   *
   * @return the event-chain description {@code chain.json}
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public AgentResult design(Asked asked) {
    return run(asked, PROMPT.name(), List.of(ChatMessage.user(prompt(asked))));
  }

  /**
   * Corrects a design that failed in the simulation.
   *
   * @param present the present description
   * @param verdict what failed
   * @param why what is wrong with the design
   */
  public AgentResult correct(Asked asked, SourceText present, String verdict, String why) {
    List<ChatMessage> conversation =
        List.of(
            ChatMessage.user(prompt(asked)),
            ChatMessage.assistant("```json\n" + present.text().strip() + "\n```\n"),
            ChatMessage.user(AGAIN.render(Map.of("verdict", verdict, "why", why))));
    return run(asked, AGAIN.name(), conversation);
  }

  private AgentResult run(Asked asked, String prompt, List<ChatMessage> conversation) {
    return new RepairLoop(context, "design", AnswerKind.JSON)
        .reading(DesignSchema::asArray)
        .run(
            ProjectFolder.DESCRIPTION,
            prompt,
            conversation,
            Optional.of(DesignSchema.of(asked.requirements(), asked.base(), asked.messages())),
            text -> check(text, asked.requirements(), asked.base(), asked.messages()));
  }

  private static String prompt(Asked asked) {
    SoftwareBase base = asked.base();
    MessageText types = MessageText.of(asked.messages(), base);
    SourceText components = SourceText.of("components", base.componentsText());
    Map<String, String> values =
        Map.of(
            "system", asked.system(),
            "frequency", RuleText.number(asked.frequency()),
            "requirements", RuleText.items(asked.requirements().items()),
            "design rules",
                asked.designRules().map(rules -> RuleText.items(rules.items())).orElse("None."),
            "software component description in json format", NotAsked.without(components),
            "signals", SignalText.of(base.signalsText()),
            "message types", types.definitions(),
            "message packages", types.packages());
    return PROMPT.render(values);
  }

  static List<Diagnostic> check(
      SourceText text, Requirements requirements, SoftwareBase base, MessageCatalog messages) {
    Modeled<EventChain> chain =
        EventChainReader.read(text, "chain", requirements.items(), OptionalDouble.empty());
    List<Diagnostic> diagnostics = new ArrayList<>(chain.diagnostics());
    base.addUnasked(chain.root(), chain.root());
    // No answer is asked for processors, so that none is refused for their load.
    chain.root().getSoftware().forEach(node -> node.setMappedTo(null));
    diagnostics.addAll(base.check(chain.root(), chain.origins()::locate));
    diagnostics.addAll(
        ChainAnalysis.of(messages, base.signals())
            .check(chain.root(), chain.origins()::locate)
            .diagnostics());
    Document json = JsonDocument.parse(text);
    if (EventChainSchema.components(json.root()).isArray()) {
      diagnostics.addAll(new ChainCheck(requirements, base).check(json));
    }
    return diagnostics;
  }
}
