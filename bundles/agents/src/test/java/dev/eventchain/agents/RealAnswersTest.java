package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Designs by language models for the AEB example; the README there gives their dates. */
class RealAnswersTest {
  private static final Path ANSWERS = Path.of("src/test/resources/real-answers");

  @ParameterizedTest
  @ValueSource(strings = {"run1", "run3"})
  void aSignalThatLeavesTheChainUndeclaredIsRefusedWithTheRemedy(String run) throws IOException {
    String answer = answer(run);
    ScriptedModel model = new ScriptedModel().answer(answer).answer(declared(answer));
    AgentResult result = design(model);
    assertEquals(
        List.of("contract.consumer.missing"),
        result.attempts().get(0).findings().stream().map(Diagnostic::id).toList());
    assertEquals(2, result.attempts().size());
    String repair = model.requests.get(1).messages().get(2).content();
    ExpectedFile.check(ANSWERS.resolve(run + "-design.repair.md"), repair + "\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"run1", "run3"})
  void declaredItIsAcceptedAtFirstShot(String run) {
    AgentResult result = design(new ScriptedModel().answer(declared(answer(run))));
    assertEquals(1, result.attempts().size());
    assertEquals(List.of(), result.diagnostics());
  }

  /** Adds the declaration that the prompt requires for the topic of such a signal. */
  private static String declared(String answer) {
    String type = "\"message_type\": \"std_msgs/msg/Bool\",";
    assertEquals(2, answer.split(type, -1).length);
    return answer.replace(
        type, type + "\n\"consumer\": \"external\",\n\"requirements\": [\"AEB-3\"],");
  }

  private static String answer(String run) {
    return SourceText.read(ANSWERS.resolve(run + "-design.md")).text();
  }

  private static AgentResult design(ScriptedModel model) {
    Path project = ExampleWorkflow.AEB.project();
    return new DesignAgent(AgentContext.of(model))
        .design(
            new DesignAgent.Asked(
                "Autonomous Emergency Braking",
                20.0,
                Requirements.read(SourceText.read(project.resolve("requirements.md"))),
                Optional.of(Requirements.read(SourceText.read(project.resolve("design-rules.md")))),
                SoftwareBase.read(project.resolve("software-base")),
                MessageCatalog.of(List.of(project.resolve("software-base/msg")))));
  }
}
