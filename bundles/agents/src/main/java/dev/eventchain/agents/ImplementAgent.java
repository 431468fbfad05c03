package dev.eventchain.agents;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.chain.RequirementCheck;
import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.agents.component.ImplementationCheck;
import dev.eventchain.agents.prompt.MessageText;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.agents.prompt.RuleText;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.model.Signal;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.ComponentProbe;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Implements one component of an event chain as a Python class (the paper's Section IV-C and
 * Appendix B).
 */
public final class ImplementAgent {
  private static final PromptTemplate PROMPT = PromptTemplate.load("implement/v1");
  private static final String MESSAGES_IN_CODE =
      "A message arrives as an object whose fields are attributes, an array of messages as a sequence"
          + " of such objects, which may be empty. Their classes are not there to be imported:";
  private static final PromptTemplate VERDICT = PromptTemplate.load("verdict/v1");

  private final AgentContext context;
  private final ComponentProbe probe;
  private final List<Signal> signals;

  /**
   * Creates an agent for a context.
   *
   * @param probe the probe that checks the answers, and calls them in a confined process
   * @param signals the vehicle's signals, at whose limits the answers are called, too
   */
  public ImplementAgent(AgentContext context, ComponentProbe probe, List<Signal> signals) {
    this.context = context;
    this.probe = probe;
    this.signals = List.copyOf(signals);
  }

  /**
   * Implements a component.
   *
   * @param chain the event-chain description
   * @param component the name of the component in it
   * @param requirements the functional requirements, of which the model sees those of the component
   * @param tests the tests that the component must pass, if it has any
   * @return the Python file {@code components/NAME.py}
   * @throws IllegalArgumentException if the chain has no such component
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS if no answer passed its checks;
   *     and as the model throws
   */
  public AgentResult implement(
      SourceText chain,
      String component,
      Requirements requirements,
      Optional<ComponentTester> tests) {
    ChainView.Component described = ChainView.component(chain, component);
    return loop()
        .run(
            file(component),
            PROMPT,
            values(described, requirements),
            Optional.empty(),
            check(described, tests));
  }

  /**
   * Corrects a component that fails in the simulation of the whole chain.
   *
   * @param chain the event-chain description
   * @param component the name of the component in it
   * @param requirements as in {@link #implement}
   * @param tests the tests that the component must pass, if it has any
   * @param present the present code of the component
   * @param verdict the failure, with the component's inputs and outputs around that time
   * @param why what is wrong with the component
   * @return the Python file; the present one if the model finds no fault in it
   * @throws IllegalArgumentException if the chain has no such component
   * @throws dev.eventchain.diagnostics.DiagnosticException as in {@link #implement}
   */
  public AgentResult correct(
      SourceText chain,
      String component,
      Requirements requirements,
      Optional<ComponentTester> tests,
      SourceText present,
      String verdict,
      String why) {
    ChainView.Component described = ChainView.component(chain, component);
    List<ChatMessage> conversation =
        List.of(
            ChatMessage.user(PROMPT.render(values(described, requirements))),
            ChatMessage.assistant("```python\n" + present.text() + "```\n"),
            ChatMessage.user(VERDICT.render(Map.of("verdict", verdict, "why", why))));
    return loop()
        .run(
            file(component),
            VERDICT.name(),
            conversation,
            Optional.empty(),
            check(described, tests));
  }

  private RepairLoop loop() {
    return new RepairLoop(context, "implement", AnswerKind.PYTHON);
  }

  private static String file(String component) {
    return "components/" + component + ".py";
  }

  private Map<String, String> values(ChainView.Component described, Requirements requirements) {
    return Map.of(
        "requirements",
        RuleText.items(RequirementCheck.own(described.json(), requirements)),
        "Description of target software extracted from the event chain description.",
        JsonLayout.compact(NotAsked.without(described.json()))
            + MessageText.ofValues(described.inputTypes(), context.messages(), MESSAGES_IN_CODE));
  }

  private Function<SourceText, List<Diagnostic>> check(
      ChainView.Component described, Optional<ComponentTester> tests) {
    return new ImplementationCheck(probe, described, tests, signals, context.messages())::check;
  }
}
