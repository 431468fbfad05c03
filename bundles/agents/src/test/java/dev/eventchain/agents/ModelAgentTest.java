package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.agents.prompt.PromptTemplate;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The model agent on the chain of its own one-shot example. */
class ModelAgentTest {
  private static final SourceText CHAIN =
      SourceText.of("chain.json", PromptTemplate.resource("model/example.chain.json"));
  private static final String INSTANCE = PromptTemplate.resource("model/example.instance.json");
  private static final Requirements REQUIREMENTS =
      Requirements.read(
          SourceText.of("r.md", PromptTemplate.resource("model/example.requirements.md")));

  @TempDir Path folder;
  private SoftwareBase base;

  @BeforeEach
  void existingComponents() throws IOException {
    Files.writeString(
        folder.resolve("components.json"),
        """
        [{"name": "Rain_Detection", "file": "components.json"},
         {"name": "Wiper_Motor", "implementation": "node"}]
        """);
    base = SoftwareBase.read(folder);
  }

  @Test
  void theOneShotExampleIsRight() {
    AgentResult result = run(new ScriptedModel().answer(INSTANCE));
    assertEquals(List.of(), result.diagnostics());
    assertEquals(1, result.attempts().size());
  }

  @Test
  void thePromptHoldsMetamodelExampleAndChain() {
    ScriptedModel model = new ScriptedModel().answer(INSTANCE);
    run(model);
    String prompt = model.requests.get(0).messages().get(0).content();
    assertTrue(prompt.contains("class EventChain -- "), prompt);
    assertTrue(prompt.contains("The chain is called rain_wiper."), prompt);
    assertFalse(prompt.contains("{{"), prompt);
  }

  @ParameterizedTest
  @CsvSource({
    "'\"frequency\": 25.0', '\"frequency\": 40.0'",
    "'\"eClass\": \"SoftwareNode\"', '\"eClass\": \"Component\"'",
    "'\"topicName\": \"/rain/wetness\"', '\"topic\": \"/rain/wetness\"'",
    "'\"nextstep\": \"Wiper_Motor\"', '\"nextstep\": \"Driver\"'",
    "'\"origin\": \"GENERATED\"', '\"origin\": \"EXISTING\"'",
    "'\"unit\": \"1\"', '\"unit\": \"km\"'"
  })
  void aSlipIsFoundAndRepaired(String right, String wrong) {
    String slip = INSTANCE.replaceFirst(right, wrong);
    AgentResult result = run(new ScriptedModel().answer(slip).answer(INSTANCE));
    assertEquals(2, result.attempts().size());
    Diagnostic first = result.attempts().get(0).findings().get(0);
    assertTrue(first.id().startsWith("modeler."), first.id());
    assertTrue(first.location().line() > 0);
    assertEquals("instance.json", first.location().file());
  }

  private AgentResult run(ScriptedModel model) {
    return new ModelAgent(AgentContext.of(model))
        .model(EventChainMetamodel.documented(), CHAIN, "rain_wiper", REQUIREMENTS, base)
        .result();
  }
}
