package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.answer.AnswerKind;
import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatMessage;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.messages.MessageCatalog;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

/** Repeated requests with findings. */
class RepairLoopTest {
  private static final PromptTemplate PROMPT = PromptTemplate.of("test/v1", "Give {{what}}.");

  private final ScriptedModel model = new ScriptedModel();
  private final List<String> progress = new ArrayList<>();

  private Predicate<Diagnostic> accepted = finding -> false;

  @Test
  void anAnswerThatPassesIsTakenAtOnceWithItsWarnings() {
    model.answer("[\"careful\"]");
    AgentResult result = run(3);
    assertEquals("[\n  \"careful\"\n]\n", result.text());
    assertEquals("test/v1", result.prompt());
    assertEquals(1, result.attempts().size());
    assertEquals(List.of("test.careful"), ids(result.diagnostics()));
    assertEquals(List.of(ChatMessage.user("Give JSON.")), model.requests.get(0).messages());
    assertEquals(List.of("asking for a.json"), progress);
  }

  @Test
  void aFailedCheckGoesBackIntoTheSameConversation() {
    model.answer("Here: [\"wrong\"]").answer("[\"right\"]");
    AgentResult result = run(3);
    assertEquals("[\n  \"right\"\n]\n", result.text());
    assertEquals(2, result.attempts().size());
    assertEquals(List.of("test.wrong"), ids(result.attempts().get(0).findings()));
    assertEquals(List.of(), result.diagnostics());
    List<ChatMessage> second = model.requests.get(1).messages();
    assertEquals(ChatMessage.user("Give JSON."), second.get(0));
    assertEquals(ChatMessage.assistant("Here: [\"wrong\"]"), second.get(1));
    assertEquals(
        ChatMessage.user(
            """
            Your answer was checked by programs, and it cannot be used yet. This was found:

            1. Line 2, column 3: It is wrong. [test.wrong]
               > "wrong"
               Make it right.

            Correct this, and leave the rest as it is. Answer again with the whole JSON, not only \
            with the changes, and nothing else.\
            """),
        second.get(2));
    assertEquals(3, second.size());
    assertEquals("asking again for a.json: It is wrong.", progress.get(1));
  }

  @Test
  void anAnswerWithoutAnArtefactGoesBackToo() {
    model.answer("Sorry.").answer("[\"right\"", FinishReason.LENGTH).answer("[\"right\"]");
    AgentResult result = run(3);
    assertEquals(
        List.of("agents.answer.none", "agents.answer.truncated"),
        result.attempts().stream().flatMap(a -> ids(a.findings()).stream()).toList());
    assertEquals(5, model.requests.get(2).messages().size());
  }

  @Test
  void afterTheLastRepairTheFindingsOfTheLastAnswerAreTheResult() {
    ScriptedModel stubborn =
        new ScriptedModel().answer("nothing").answer("[\"wrong\", \"careful\"]");
    DiagnosticException e = assertThrows(DiagnosticException.class, () -> run(stubborn, 1));
    assertEquals(Reason.FINDINGS, e.reason());
    assertEquals(
        List.of("agents.answer.rejected", "test.careful", "test.wrong"), ids(e.diagnostics()));
    assertTrue(e.diagnostics().get(0).message().contains("in 2 attempts"));
    assertEquals(2, stubborn.requests.size());
  }

  @Test
  void withoutRepairsTheModelIsAskedOnce() {
    model.answer("nothing");
    assertThrows(DiagnosticException.class, () -> run(0));
    assertEquals(1, model.requests.size());
  }

  @Test
  void aLongListOfFindingsIsCutInTheMessage() {
    String many = "[" + "\"wrong\",".repeat(40) + "]";
    model.answer(many).answer("[\"right\"]");
    run(1);
    String message = model.requests.get(1).messages().get(2).content();
    assertTrue(message.contains("\n25. "), message);
    assertTrue(message.contains("\nAnd 15 more.\n"), message);
  }

  @Test
  void whatPeopleAcceptSendsNoAnswerBack() {
    accepted = finding -> finding.id().equals("test.wrong");
    AgentResult result = run(model.answer("[\"wrong\"]"), 1);
    assertTrue(result.text().contains("wrong"), result.text());
    assertEquals(List.of("test.wrong"), ids(result.diagnostics()));
  }

  @Test
  void whatIsNoAnswerIsNeverAccepted() {
    accepted = finding -> true;
    model.answer("nothing");
    assertThrows(DiagnosticException.class, () -> run(0));
  }

  private AgentResult run(int repairs) {
    return run(model, repairs);
  }

  private AgentResult run(ScriptedModel asked, int repairs) {
    AgentContext context =
        new AgentContext(
            asked,
            repairs,
            accepted,
            progress::add,
            exchange -> {},
            () -> MessageCatalog.of(List.of()));
    return new RepairLoop(context, "design", AnswerKind.JSON)
        .run("a.json", PROMPT, Map.of("what", "JSON"), Optional.empty(), RepairLoopTest::check);
  }

  private static List<Diagnostic> check(SourceText text) {
    List<Diagnostic> findings = new ArrayList<>();
    for (int at = text.text().indexOf("wrong");
        at >= 0;
        at = text.text().indexOf("wrong", at + 1)) {
      findings.add(
          Diagnostic.of(Rule.error("test.wrong"), "It is wrong.", text.at(at - 1))
              .withHint("Make it right."));
    }
    if (text.text().contains("careful")) {
      findings.add(Diagnostic.of(Rule.warning("test.careful"), "Be careful.", text.at(0)));
    }
    return findings;
  }

  private static List<String> ids(List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(Diagnostic::id).toList();
  }
}
