package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.llm.ChatModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The recordings of the examples answer their prompts. When a prompt has changed, run this test
 * with {@code -Drecordings.update=true}: it gives the changed prompts the answers of the recordings
 * that they replace.
 */
class ExampleRecordingsTest {
  private static final String STALE =
      """
      The recordings of %s do not answer its prompts any more:
      %s
      If the old answers still fit, give them to the new prompts with
          mvn -pl bundles/agents -am test -Dtest=ExampleRecordingsTest -Drecordings.update=true \
      -Dsurefire.failIfNoSpecifiedTests=false
      If not, answer the prompts anew with
          ./eventchain run %s --llm handoff:FOLDER --record
      and delete the recordings that are no longer used.\
      """;

  static List<ExampleWorkflow> examples() {
    return List.of(ExampleWorkflow.AEB, ExampleWorkflow.ACC, ExampleWorkflow.LANE_DEPARTURE);
  }

  @ParameterizedTest
  @MethodSource("examples")
  void everyTaskIsAnsweredAtOnceAndEveryRecordingIsUsed(
      ExampleWorkflow example, @TempDir Path folder) throws IOException {
    if (Boolean.getBoolean("recordings.update")) {
      RecordingsUpdate.run(example.recordings(), folder, example::run);
    }
    Map<String, AgentResult> results = replay(example);
    assertTrue(
        results.keySet().containsAll(List.of("chain.json", "instance.json", "generated.ocl")));
    assertTrue(results.size() > 4, "two components or more are missing in each example");
    results.forEach(
        (file, result) -> {
          assertEquals(List.of(), result.diagnostics(), file);
          assertEquals(1, result.attempts().size(), file);
          assertEquals("authored", result.attempts().get(0).response().provenance(), file);
        });
    try (Stream<Path> files = Files.walk(example.recordings())) {
      assertEquals(results.size(), files.filter(Files::isRegularFile).count());
    }
  }

  private static Map<String, AgentResult> replay(ExampleWorkflow example) {
    try {
      return example.run(
          ChatModels.open("replay", ExampleWorkflow.MODEL, example.recordings(), false));
    } catch (DiagnosticException e) {
      Diagnostic first = e.diagnostics().get(0);
      assertTrue(first.id().equals("llm.recording.missing"), () -> e.diagnostics().toString());
      String folder = "examples/" + example.folder();
      return fail(STALE.formatted(folder, first.message(), folder));
    }
  }
}
