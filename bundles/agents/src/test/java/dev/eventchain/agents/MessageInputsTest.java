package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.PythonEnvironment;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Components whose inputs are lists of messages. */
class MessageInputsTest {
  private static final Path FOLDER = Path.of("src/test/resources/message-inputs");
  private static final SourceText CHAIN = SourceText.read(FOLDER.resolve("chain.json"));
  private static final String DEFINITION =
      "\ndemo_msgs/msg/Echo:\n uint8 sensor\n float32 distance\n geometry_msgs/Point place\n";
  private static final Requirements REQUIREMENTS =
      Requirements.read(SourceText.of("r.md", "- R-1: The system shall find the nearest echo.\n"));

  private static AgentContext context(ScriptedModel model) {
    return AgentContext.of(model, () -> MessageCatalog.of(List.of(FOLDER.resolve("msg"))));
  }

  private static String text(String name) {
    return SourceText.read(FOLDER.resolve(name)).text();
  }

  private static ComponentTester tests(String text) {
    return ComponentTester.read(
        SourceText.of("tests.yaml", text), CHAIN, "Nearest_Echo", REQUIREMENTS);
  }

  @Test
  void testsOfMessagesAreAcceptedAndTellRightFromWrong() {
    ScriptedModel model = new ScriptedModel().answer(text("good.json"));
    AgentResult proposed =
        new TestAgent(context(model)).propose(CHAIN, "Nearest_Echo", REQUIREMENTS);
    assertEquals(1, proposed.attempts().size());
    String prompt = model.requests.get(0).messages().get(0).content();
    assertTrue(prompt.contains(DEFINITION), prompt);
    assertTrue(prompt.contains("\ngeometry_msgs/msg/Point:\n float64 x\n"), prompt);

    ComponentTester tests = tests(proposed.text());
    ScriptedModel author =
        new ScriptedModel().answer(fenced("first-only.py")).answer(fenced("right.py"));
    AgentResult code =
        new ImplementAgent(
                context(author),
                new ComponentProbe(PythonEnvironment.ensure(message -> {})),
                List.of())
            .implement(CHAIN, "Nearest_Echo", REQUIREMENTS, Optional.of(tests));
    assertTrue(author.requests.get(0).messages().get(0).content().contains(DEFINITION));
    assertEquals(text("right.py"), code.text());
    List<Diagnostic> findings = code.attempts().get(0).findings();
    assertEquals(List.of("component.test.failed"), findings.stream().map(Diagnostic::id).toList());
    assertTrue(findings.get(0).message().contains("the second one is nearer"), findings::toString);
  }

  /** Calls at limits hold messages, too: not only tests find code that expects something else. */
  @Test
  void codeIsTriedWithMessages() {
    ScriptedModel author =
        new ScriptedModel()
            .answer(fenced("right.py").replace("echo.place.x", "echo[\"place\"][\"x\"]"))
            .answer(fenced("right.py"));
    AgentResult code =
        new ImplementAgent(
                context(author),
                new ComponentProbe(PythonEnvironment.ensure(message -> {})),
                List.of())
            .implement(CHAIN, "Nearest_Echo", REQUIREMENTS, Optional.empty());
    List<Diagnostic> findings = code.attempts().get(0).findings();
    assertEquals("component.raised", findings.get(0).id());
    assertEquals(2, code.attempts().size());
  }

  private static String fenced(String file) {
    return "```python\n" + text(file) + "```";
  }

  @Test
  void whatIsNoMessageIsRefused() {
    String number = text("good.json").replace("\"echoes\": []", "\"echoes\": [1.0]");
    assertFalse(tests(number).diagnostics().isEmpty());
    assertEquals(List.of(), tests(text("good.json")).diagnostics());
  }
}
