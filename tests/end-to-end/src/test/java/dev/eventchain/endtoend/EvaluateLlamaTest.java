package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.LlamaServer;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests a real server whose language model has random weights: each run fails, with reported
 * errors.
 */
class EvaluateLlamaTest {

  private static final String KEY = "sk-of-this-server";

  /** Context size for the prompts of a small project, with one token per character. */
  private static final int CONTEXT = 65_536;

  @TempDir Path folder;

  @InTurn
  @Test
  void randomAnswersScoreNothingByFailureClass() throws IOException, InterruptedException {
    try (LlamaServer server = LlamaServer.start(KEY, CONTEXT)) {
      ProjectCopy project = ProjectCopy.of("radar-aeb", folder);
      project.write(
          "eventchain.yaml",
          """
          name: radar_aeb
          repairs: 1
          services:
            llamacpp: {url: "%s", key: LLAMA_KEY, deadline_s: 1800, silence_s: 1800, maximum_tokens: 150}
          """
              .formatted(server.url()));
      forget(project, "Collision_Warning");
      Program.Ended ended =
          new Program()
              .with("LLAMA_KEY", KEY)
              .run(
                  "evaluate",
                  project.path(),
                  "--runs",
                  2,
                  "--models",
                  "llamacpp/tiny-random",
                  "--llm",
                  "live")
              .expect(0);
      Path file = project.path().resolve("out/evaluation/evaluation.json");
      JsonNode model = new ObjectMapper().readTree(file.toFile()).at("/models/0");
      assertEquals(2, model.path("counted").asInt(), ended::out);
      for (String artefact : new String[] {"chainModel", "functionCode", "overall"}) {
        JsonNode rate = model.path(artefact).path("withRepair");
        assertEquals(0, rate.path("passed").asInt(-1), ended::out);
        assertEquals(2, rate.path("judged").asInt(), ended::out);
      }
      ended.says("failed by").says("design: ").says("implement: ");
      assertTrue(model.at("/tokens/output").asInt() > 0);
      assertTrue(model.path("measuresALanguageModel").asBoolean());
      assertFalse((ended.out() + ended.err()).contains(KEY));
    }
  }

  /** Removes a component that the edited chain needs. */
  private static void forget(ProjectCopy project, String component) throws IOException {
    ObjectMapper mapper = new ObjectMapper();
    Path file = project.path().resolve("software-base/components.json");
    ArrayNode components = (ArrayNode) mapper.readTree(file.toFile());
    for (int i = 0; i < components.size(); i++) {
      if (components.get(i).path("name").asText().equals(component)) {
        components.remove(i);
      }
    }
    mapper.writeValue(file.toFile(), components);
  }
}
