package dev.eventchain.agents;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.agents.chain.RequirementCheck;
import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.Requirements;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Proposes tests of a component from its requirements and its description, without access to code.
 * The user may edit the proposal.
 */
public final class TestAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("test/v1");
  private static final PromptTemplate AGAIN = PromptTemplate.load("retest/v1");

  private static final String MESSAGES_IN_TESTS =
      "In \"inputs\", a message is an object with each of its fields by its name, a message within"
          + " it likewise, and an array of messages is an array of such objects:";

  private final AgentContext context;

  /** Creates an agent for a context. */
  public TestAgent(AgentContext context) {
    this.context = context;
  }

  /**
   * Proposes tests.
   *
   * @param chain the event-chain description
   * @param component the name of the component in it
   * @param requirements the functional requirements
   * @return the tests in JSON, hence also YAML: see {@link ComponentTester}
   * @throws IllegalArgumentException if the chain has no such component
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public AgentResult propose(SourceText chain, String component, Requirements requirements) {
    Component described = ChainView.component(chain, component);
    return new RepairLoop(context, "test", AnswerKind.JSON)
        .run(
            file(component),
            PROMPT,
            values(described, requirements),
            Optional.empty(),
            text -> check(text, described, requirements));
  }

  /**
   * Corrects tests that demand too much.
   *
   * @param present the present tests, as {@link #propose} returned them
   * @param why what is wrong with them
   * @return as {@link #propose}
   */
  public AgentResult correct(
      SourceText chain, String component, Requirements requirements, String present, String why) {
    Component described = ChainView.component(chain, component);
    List<ChatMessage> conversation =
        List.of(
            ChatMessage.user(PROMPT.render(values(described, requirements))),
            ChatMessage.assistant("```json\n" + present.strip() + "\n```\n"),
            ChatMessage.user(AGAIN.render(Map.of("why", why))));
    return new RepairLoop(context, "test", AnswerKind.JSON)
        .run(
            file(component),
            AGAIN.name(),
            conversation,
            Optional.empty(),
            text -> check(text, described, requirements));
  }

  /** Returns the name of the tests in findings; the user's file has the same one in YAML. */
  private static String file(String component) {
    return ProjectLayout.TESTS + "/" + component + ".json";
  }

  private Map<String, String> values(Component described, Requirements requirements) {
    return Map.of(
        "requirements",
        RuleText.items(RequirementCheck.own(described.json(), requirements)),
        "description",
        JsonLayout.compact(NotAsked.without(described.json()))
            + MessageText.ofValues(described.inputTypes(), context.messages(), MESSAGES_IN_TESTS));
  }

  static List<Diagnostic> check(SourceText text, Component component, Requirements requirements) {
    return ComponentTester.read(text, DocumentFormat.JSON, component, requirements).complaints();
  }
}
