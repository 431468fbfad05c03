package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recorded repair: an answer with an invented topic, its findings, and the corrected answer. */
class RecordedRepairTest {
  private static final Path BASE = Path.of("src/test/resources/design/base");
  private static final Path RECORDINGS = Path.of("src/test/resources/repair/recordings");

  @Test
  void theRecordedRepairIsReplayed(@TempDir Path folder) throws IOException {
    if (Boolean.getBoolean("recordings.update")) {
      RecordingsUpdate.run(RECORDINGS, folder, RecordedRepairTest::design);
    }
    AgentResult result = design(ChatModels.open("replay", "authored", RECORDINGS, false));
    assertEquals(2, result.attempts().size());
    assertEquals(
        List.of("contract.publisher.missing"),
        result.attempts().get(0).findings().stream().map(Diagnostic::id).toList());
    assertEquals(List.of(), result.diagnostics());
  }

  private static AgentResult design(ChatModel model) {
    Requirements requirements = Requirements.read(SourceText.read(BASE.resolve("requirements.md")));
    return new DesignAgent(AgentContext.of(model))
        .design(
            new DesignAgent.Asked(
                "Test",
                20.0,
                requirements,
                Optional.empty(),
                SoftwareBase.read(BASE),
                MessageCatalog.of(List.of())));
  }
}
