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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The recordings of the AEB example answer its prompts. When a prompt has changed, run this test
 * with {@code -Drecordings.update=true}: the changed prompts are then given the answers of the
 * recordings that they replace.
 */
class AebRecordingsTest {
  private static final String STALE =
      """
      The recordings of examples/aeb do not answer its prompts any more:
      %s
      If the old answers still fit, give them to the new prompts with
          mvn -pl bundles/agents -am test -Dtest=AebRecordingsTest -Drecordings.update=true \
      -Dsurefire.failIfNoSpecifiedTests=false
      If not, answer the prompts anew with
          ./eventchain run examples/aeb --llm handoff:FOLDER --record
      and delete the recordings that are no longer used.""";

  @Test
  void everyTaskIsAnsweredAtOnceAndNothingIsLeftToSay(@TempDir Path folder) throws IOException {
    if (Boolean.getBoolean("recordings.update")) {
      RecordingsUpdate.run(AebWorkflow.RECORDINGS, folder, AebWorkflow::run);
    }
    Map<String, AgentResult> results = replay();
    assertEquals(
        List.of(
            "chain.json",
            "components/TTC_Calculation.py",
            "components/Braking_Decision.py",
            "instance.json",
            "generated.ocl"),
        List.copyOf(results.keySet()));
    results.forEach(
        (file, result) -> {
          assertEquals(List.of(), result.diagnostics(), file);
          assertEquals(1, result.attempts().size(), file);
          assertEquals("authored", result.attempts().get(0).response().provenance(), file);
        });
  }

  @Test
  void everyRecordingIsUsed() throws IOException {
    try (Stream<Path> files = Files.walk(AebWorkflow.RECORDINGS)) {
      assertEquals(5, files.filter(Files::isRegularFile).count());
    }
  }

  private static Map<String, AgentResult> replay() {
    try {
      return AebWorkflow.run(
          ChatModels.open("replay", AebWorkflow.MODEL, AebWorkflow.RECORDINGS, false));
    } catch (DiagnosticException e) {
      Diagnostic first = e.diagnostics().get(0);
      assertTrue(first.id().equals("llm.recording.missing"), () -> e.diagnostics().toString());
      return fail(STALE.formatted(first.message()));
    }
  }
}
